// profile_test: how far does the map leave the chord of an edge, and where is the best place for a new vertex?
//   pt = max e_j > threshold, k = the place that maximises e_j j (n - j) in the middle third, e_j = |D_j - ((n-j) D_0 + j D_n) / n|
//   contract: hls/edge/profile_test.hpp
//   parameters  SamplesPerClock  1, 4 or 16 quads asked for at once;  InFlight  groups of them, and edges, between in and out
//   port  quad_*   read port of the displacement map: SamplesPerClock times quad_request_t asked for together, of which those with
//                  their bit of quad_req_mask_o set are wanted, and SamplesPerClock times texel_quad_t answered together. The requests
//                  without it may lie anywhere and their answers are not looked at. Wanted lanes are the lowest. The answer comes from
//                  registers.
//
//   An edge of n intervals takes n + 1 samples, both ends first: ceil((n + 1) / SamplesPerClock) groups, a group a clock. An edge
//   shorter than 1.5 texels reads nothing, takes one clock and passes in order.
//   latency 37 + log2 SamplesPerClock + groups + that of the memory (1 when it answers in the next clock); initiation interval: the
//   groups, one at least, while the memory takes and gives a group a clock and answers within InFlight - 60 clocks
//   all outputs registered, or a choice between two registers; no path from any ready input to a ready output
//
//   in --[profile_levels]--[FIFO]--[group 0, 1 ..]--+--[profile_places]--[FIFO]--> quad_req
//                                      |            +--[FIFO: fractions]--+
//                                   [order]                    quad_rsp --+--[bilinear]--[profile_error]--[FIFO]--+
//                                      +--------------------------------------------------------------------------+--> out
module profile_test
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
  import edge_pkg::*;
  import latency_pkg::*;
#(
  parameter int unsigned SamplesPerClock = 4,
  parameter int unsigned InFlight = 128
) (
  input  logic                                clk_i,
  input  logic                                rst_ni,
  input  map_regs_t                           map_i,
  input  profile_test_regs_t                  regs_i,
  input  logic                                in_valid_i,
  output logic                                in_ready_o,
  input  profile_test_in_t                    in_i,
  output logic                                out_valid_o,
  input  logic                                out_ready_i,
  output profile_test_out_t                   out_o,
  output logic                                quad_req_valid_o,
  input  logic                                quad_req_ready_i,
  output quad_request_t [SamplesPerClock-1:0] quad_req_o,
  output logic          [SamplesPerClock-1:0] quad_req_mask_o,
  input  logic                                quad_rsp_valid_i,
  input  texel_quad_t   [SamplesPerClock-1:0] quad_rsp_i
);
  if (SamplesPerClock != 1 && SamplesPerClock != 4 && SamplesPerClock != 16) begin : gen_samples
    $error("SamplesPerClock is 1, 4 or 16");
  end
  if (InFlight < 8) begin : gen_in_flight
    $error("InFlight is 8 at least");
  end
  localparam int unsigned PlacesLatency = 7;
  localparam int unsigned CountBits = $clog2(InFlight + 1);

  typedef struct packed {
    logic                    forward;
    logic        [2:0]       levels;
    logic signed [1:0][25:0] extent;
    coordinate_t [1:0]       u1;
  } edge_t;
  typedef struct packed {
    logic       last;
    logic       forward;
    logic [2:0] levels;
    logic [4:0] group;
  } group_t;
  typedef struct packed {
    logic          [SamplesPerClock-1:0] wanted;
    quad_request_t [SamplesPerClock-1:0] quad;
  } request_t;
  typedef struct packed {
    group_t                                   group;
    fraction_t [SamplesPerClock-1:0][1:0] fraction;
  } waiting_t;

  // ---- edges, with the number of their intervals
  edge_t measured, head;
  logic head_valid, head_leaves;
  profile_levels i_levels (
    .clk_i, .u1_i(in_i.u1), .u2_i(in_i.u2), .levels_o(measured.levels), .extent_o(measured.extent)
  );
  delay #(.T(coordinate_t [1:0]), .Stages(ProfileLevels)) i_u1 (
    .clk_i, .x_i(in_i.u1), .y_o(measured.u1)
  );
  delay #(.Stages(ProfileLevels)) i_forward (
    .clk_i, .x_i(in_i.forward), .y_o(measured.forward)
  );
  stream_pipe #(.T(edge_t), .Latency(ProfileLevels)) i_edges (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .data_i(measured),
    .out_valid_o(head_valid),
    .out_ready_i(head_leaves),
    .out_o(head)
  );

  // ---- groups: one a clock while there are places for what it leads to. An edge has its place in the order from its first group on.
  logic [4:0] group_q;
  logic [CountBits-1:0] asked_q;
  logic reads, room, room_q, order_ready, request_ready, go, ask, last;
  assign reads = head.levels != '0;
  assign room = (group_q != '0 || order_ready) && room_q;
  assign last = group_q == (reads ? (5'd1 << head.levels) >> $clog2(SamplesPerClock) : 5'd0);
  assign ask = head_valid && room && reads;
  assign go = head_valid && room && (request_ready || !reads);
  assign head_leaves = go && last;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      group_q <= '0;
      asked_q <= '0;
      room_q <= 1'b1;
    end else begin
      if (go) group_q <= last ? '0 : group_q + 5'd1;
      asked_q <= asked_q + CountBits'(ask && request_ready) - CountBits'(quad_rsp_valid_i);
      // A group may have been asked for since the count.
      room_q <= asked_q < CountBits'(InFlight - 1);
    end
  end

  // ---- requests
  map_address_out_t [SamplesPerClock-1:0] address;
  logic [SamplesPerClock-1:0] wanted;
  profile_places #(.SamplesPerClock(SamplesPerClock)) i_places (
    .clk_i,
    .map_i,
    .u1_i(head.u1),
    .extent_i(head.extent),
    .levels_i(head.levels),
    .group_i(group_q),
    .address_o(address),
    .wanted_o(wanted)
  );
  request_t request, request_out;
  stream_pipe #(.T(request_t), .Latency(PlacesLatency)) i_requests (
    .clk_i,
    .rst_ni,
    .in_valid_i(ask),
    .in_ready_o(request_ready),
    .data_i(request),
    .out_valid_o(quad_req_valid_o),
    .out_ready_i(quad_req_ready_i),
    .out_o(request_out)
  );
  assign quad_req_o = request_out.quad;
  assign quad_req_mask_o = request_out.wanted;

  // ---- what waits for the answers: pushed beside the request, so that it is at the head before the memory can answer
  logic [PlacesLatency-1:0] placing_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) placing_q <= '0;
    else placing_q <= PlacesLatency'({placing_q, ask && request_ready});
  end
  group_t group;
  assign group = '{last: last, forward: head.forward, levels: head.levels, group: group_q};
  waiting_t waiting, answered;
  delay #(.T(group_t), .Stages(PlacesLatency)) i_group (.clk_i, .x_i(group), .y_o(waiting.group));
  logic unused_waiting_ready, unused_waiting_valid;
  logic [CountBits-1:0] unused_waiting_count;
  stream_fifo #(.T(waiting_t), .Depth(InFlight)) i_waiting (
    .clk_i,
    .rst_ni,
    .in_valid_i(placing_q[PlacesLatency-1]),
    .in_ready_o(unused_waiting_ready),
    .in_i(waiting),
    .out_valid_o(unused_waiting_valid),
    .out_ready_i(quad_rsp_valid_i),
    .out_o(answered),
    .count_o(unused_waiting_count)
  );

  // ---- samples
  sample_t [SamplesPerClock-1:0] sample;
  for (genvar l = 0; l < SamplesPerClock; l++) begin : gen_lane
    assign request.quad[l] = '{y: address[l].y, x: address[l].x};
    assign request.wanted[l] = wanted[l];
    assign waiting.fraction[l] = address[l].f;
    bilinear #(.Width(16), .Signed(1'b0), .Kept(SampleFraction)) i_bilinear (
      .clk_i, .q_i(quad_rsp_i[l]), .f_i(answered.fraction[l]), .y_o(sample[l])
    );
  end

  // ---- errors
  group_t sampled;
  logic [BilinearLatency-1:0] sampling_q;
  delay #(.T(group_t), .Stages(BilinearLatency)) i_sampled (
    .clk_i, .x_i(answered.group), .y_o(sampled)
  );
  always_ff @(posedge clk_i) begin
    if (!rst_ni) sampling_q <= '0;
    else sampling_q <= BilinearLatency'({sampling_q, quad_rsp_valid_i});
  end
  logic found_valid;
  profile_test_out_t found;
  profile_error #(.SamplesPerClock(SamplesPerClock)) i_error (
    .clk_i,
    .rst_ni,
    .regs_i,
    .valid_i(sampling_q[BilinearLatency-1]),
    .sample_i(sample),
    .group_i(sampled.group),
    .levels_i(sampled.levels),
    .forward_i(sampled.forward),
    .last_i(sampled.last),
    .valid_o(found_valid),
    .out_o(found)
  );

  // ---- order: edges that read and those that don't; a found word has its place since its edge has one here
  logic order_valid, order_reads, result_valid, out_leaves;
  profile_test_out_t result;
  logic unused_result_ready;
  logic [CountBits-1:0] unused_order_count, unused_result_count;
  logic ordered_valid, ordered_ready, ordered_reads;
  stream_register i_ordered (
    .clk_i,
    .rst_ni,
    .in_valid_i(go && group_q == '0),
    .in_ready_o(order_ready),
    .in_i(reads),
    .out_valid_o(ordered_valid),
    .out_ready_i(ordered_ready),
    .out_o(ordered_reads)
  );
  stream_fifo #(.Depth(InFlight)) i_order (
    .clk_i,
    .rst_ni,
    .in_valid_i(ordered_valid),
    .in_ready_o(ordered_ready),
    .in_i(ordered_reads),
    .out_valid_o(order_valid),
    .out_ready_i(out_leaves),
    .out_o(order_reads),
    .count_o(unused_order_count)
  );
  stream_fifo #(.T(profile_test_out_t), .Depth(InFlight)) i_results (
    .clk_i,
    .rst_ni,
    .in_valid_i(found_valid),
    .in_ready_o(unused_result_ready),
    .in_i(found),
    .out_valid_o(result_valid),
    .out_ready_i(out_leaves && order_reads),
    .out_o(result),
    .count_o(unused_result_count)
  );
  assign out_valid_o = order_valid && (result_valid || !order_reads);
  assign out_leaves = out_valid_o && out_ready_i;
  assign out_o = order_reads ? result : '{k: 5'd8, pt: 1'b0};
endmodule
