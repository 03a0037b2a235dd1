// edge_lane: everything that is asked of one edge: the tests, and the vertex that would be put on it. A base vertex takes the same way to
// be displaced and transformed.
//   Doggett & Hirche 2000, Figure 8; contract: test_edge, place and place_base_vertex of hls/edge/engine.hpp
//
//   in_*     lane_in_t: an edge that is not settled, or a base vertex
//   table    ReadsPerClock words of the summed-area table;  quad  SamplesPerClock quads of the map for profile_test
//   place    the map's quad at the new vertex;  normal  the normal map's quad there
//   out_*    lane_out_t, in the order of in_*
//   An edge stopped by vt or ct asks no memory; one that needs no new vertex asks none for it.
//
//   parameter VertexClocks  that a new vertex takes, 1 or 3; with three, which edges take of the memories anyway when a test asks them,
//             its arithmetic takes turns
//
//   latency 171 clocks, and those of the table's and of the map's memory; initiation interval VertexClocks where the memories deliver: an
//   edge takes 12/ReadsPerClock clocks of the table and ceil(samples/SamplesPerClock) of the map when those tests are on. Registered:
//   in_ready_o and all outputs; within, a join waits until all its parts have something. Nothing is dropped, everything can stall.
//
//   in --[edge_front]--+--[summed_height_test]--+--[new_vertex]--+--[normal_sampler]---+--[edge_back]-- out
//                      +--[profile_test]--------+                +--[displace_vertex]--+
//                      +--[FIFO]----------------+                +--[FIFO]-------------+
module edge_lane
  import formats_pkg::*;
  import surface_pkg::*;
  import memory_pkg::*;
  import edge_pkg::*;
  import lane_pkg::*;
  import latency_pkg::*;
#(
  parameter int unsigned ReadsPerClock = 12,
  parameter int unsigned SamplesPerClock = 4,
  parameter int unsigned InFlight = 128,
  parameter int unsigned VertexClocks = ReadsPerClock < 12 && SamplesPerClock == 1 ? 3 : 1
) (
  input  logic         clk_i,
  input  logic         rst_ni,
  input  engine_regs_t regs_i,

  input  logic     in_valid_i,
  output logic     in_ready_o,
  input  lane_in_t in_i,

  output logic                               table_req_valid_o,
  input  logic                               table_req_ready_i,
  output table_request_t [ReadsPerClock-1:0] table_req_o,
  input  logic                               table_rsp_valid_i,
  input  table_sum_t     [ReadsPerClock-1:0] table_rsp_i,

  output logic                                quad_req_valid_o,
  input  logic                                quad_req_ready_i,
  output quad_request_t [SamplesPerClock-1:0] quad_req_o,
  output logic          [SamplesPerClock-1:0] quad_req_mask_o,
  input  logic                                quad_rsp_valid_i,
  input  texel_quad_t   [SamplesPerClock-1:0] quad_rsp_i,

  output logic          place_req_valid_o,
  input  logic          place_req_ready_i,
  output quad_request_t place_req_o,
  input  logic          place_rsp_valid_i,
  input  texel_quad_t   place_rsp_i,

  output logic          normal_req_valid_o,
  input  logic          normal_req_ready_i,
  output quad_request_t normal_req_o,
  input  logic          normal_rsp_valid_i,
  input  normal_quad_t  normal_rsp_i,

  output logic      out_valid_o,
  input  logic      out_ready_i,
  output lane_out_t out_o
);
  localparam int unsigned FrontLatency = CalculateNewU + TexCoordTest;

  // A vertex begins at the first of VertexClocks clocks.
  logic first;
  if (VertexClocks == 1) begin : gen_every_clock
    assign first = 1'b1;
  end else begin : gen_turns
    logic [VertexClocks-1:0] turn_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) turn_q <= VertexClocks'(1);
      else turn_q <= {turn_q[VertexClocks-2:0], turn_q[VertexClocks-1]};
    end
    assign first = turn_q[0];
  end

  // Is the edge past the tests that are asked first?
  function automatic logic past(logic place, logic vt, logic ct, pass_or_tessellate_regs_t regs);
    return !place && (vt || !regs.use_vt) && (ct || !regs.use_ct);
  endfunction

  // ---- the tests without a memory
  tested_t front_data, front;
  logic    front_valid, front_ready;
  edge_front i_front (
    .clk_i, .map_i(regs_i.map), .regs_i(regs_i.view), .in_i, .out_o(front_data)
  );
  stream_pipe #(.T(tested_t), .Latency(FrontLatency)) i_front_pipe (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .data_i(front_data),
    .out_valid_o(front_valid),
    .out_ready_i(front_ready),
    .out_o(front)
  );

  // ---- the tests on the maps, side by side; every edge waits beside them, in order
  logic front_past, ask_sht, ask_pt;
  assign front_past = past(front.work.place, front.vt, front.ct, regs_i.pass);
  assign ask_sht = front_past && regs_i.pass.use_sht;
  assign ask_pt = front_past && regs_i.pass.use_pt;

  logic sht_in_ready, pt_in_ready, beside_ready, front_fire;
  assign front_ready = beside_ready && (sht_in_ready || !ask_sht) && (pt_in_ready || !ask_pt);
  assign front_fire = front_valid && front_ready;

  logic sht_valid, sht_ready;
  summed_height_test_out_t sht;
  summed_height_test #(.ReadsPerClock(ReadsPerClock), .InFlight(InFlight)) i_sht (
    .clk_i,
    .rst_ni,
    .map_i(regs_i.map),
    .regs_i(regs_i.summed_height),
    .in_valid_i(front_fire && ask_sht),
    .in_ready_o(sht_in_ready),
    .in_i('{u12: front.u12, u2: front.work.b.u, u1: front.work.a.u}),
    .table_req_valid_o,
    .table_req_ready_i,
    .table_req_o,
    .table_rsp_valid_i,
    .table_rsp_i,
    .out_valid_o(sht_valid),
    .out_ready_i(sht_ready),
    .out_o(sht)
  );

  logic pt_valid, pt_ready;
  profile_test_out_t pt;
  profile_test #(.SamplesPerClock(SamplesPerClock), .InFlight(InFlight)) i_pt (
    .clk_i,
    .rst_ni,
    .map_i(regs_i.map),
    .regs_i(regs_i.profile),
    .in_valid_i(front_fire && ask_pt),
    .in_ready_o(pt_in_ready),
    .in_i('{forward: front.forward, u2: front.work.b.u, u1: front.work.a.u}),
    .quad_req_valid_o,
    .quad_req_ready_i,
    .quad_req_o,
    .quad_req_mask_o,
    .quad_rsp_valid_i,
    .quad_rsp_i,
    .out_valid_o(pt_valid),
    .out_ready_i(pt_ready),
    .out_o(pt)
  );

  tested_t beside;
  logic beside_valid, beside_leave;
  logic [$clog2(InFlight+65)-1:0] unused_beside_count;
  stream_fifo #(.T(tested_t), .Depth(InFlight + 64)) i_beside (
    .clk_i,
    .rst_ni,
    .in_valid_i(front_fire),
    .in_ready_o(beside_ready),
    .in_i(front),
    .out_valid_o(beside_valid),
    .out_ready_i(beside_leave),
    .out_o(beside),
    .count_o(unused_beside_count)
  );

  // ---- join: the place of the new vertex is known
  logic beside_past, wait_sht, wait_pt, joined_valid, joined_ready, new_ready;
  assign beside_past = past(beside.work.place, beside.vt, beside.ct, regs_i.pass);
  assign wait_sht = beside_past && regs_i.pass.use_sht;
  assign wait_pt = beside_past && regs_i.pass.use_pt;
  assign joined_valid = beside_valid && (sht_valid || !wait_sht) && (pt_valid || !wait_pt);
  assign joined_ready = new_ready && first;
  assign beside_leave = joined_valid && joined_ready;
  assign sht_ready = beside_leave && wait_sht;
  assign pt_ready = beside_leave && wait_pt;

  weighted_t joined;
  always_comb begin
    joined.work = beside.work;
    joined.vt = beside.vt;
    joined.ct = beside.ct;
    joined.samples = beside.samples;
    joined.sht = wait_sht && sht.sht;
    joined.pt = wait_pt && pt.pt;
    joined.k = beside.work.place ? 5'd0 : wait_pt ? pt.k : 5'd8;
  end

  // ---- the new vertex
  new_vertex_t made_data, made;
  logic        made_valid, made_ready;
  new_vertex #(.Clocks(VertexClocks)) i_new_vertex (
    .clk_i, .first_i(first), .in_i(joined), .out_o(made_data)
  );
  stream_pipe #(.T(new_vertex_t), .Latency(latency_pkg::new_vertex(VertexClocks))) i_new_pipe (
    .clk_i,
    .rst_ni,
    .in_valid_i(joined_valid && first),
    .in_ready_o(new_ready),
    .data_i(made_data),
    .out_valid_o(made_valid),
    .out_ready_i(made_ready),
    .out_o(made)
  );

  // ---- the maps at the new vertex, where one is needed
  function automatic logic needed(new_vertex_t v, pass_or_tessellate_regs_t regs);
    return v.place ||
        (past(v.place, v.vt, v.ct, regs) && (regs.use_nt || regs.use_ht || v.sht || v.pt));
  endfunction

  logic ask_maps, normal_in_ready, displace_in_ready, waiting_ready, made_fire;
  assign ask_maps = needed(made, regs_i.pass);
  assign made_ready = waiting_ready && ((normal_in_ready && displace_in_ready) || !ask_maps);
  assign made_fire = made_valid && made_ready;

  logic normal_valid, normal_ready;
  normal_sampler_out_t normal;
  normal_sampler #(.InFlight(InFlight)) i_normal (
    .clk_i,
    .rst_ni,
    .map_i(regs_i.map),
    .in_valid_i(made_fire && ask_maps),
    .in_ready_o(normal_in_ready),
    .in_i('{u: made.u}),
    .normal_req_valid_o,
    .normal_req_ready_i,
    .normal_req_o,
    .normal_rsp_valid_i,
    .normal_rsp_i,
    .out_valid_o(normal_valid),
    .out_ready_i(normal_ready),
    .out_o(normal)
  );
  logic displaced_valid, displaced_ready;
  displace_vertex_out_t displaced;
  displace_vertex #(.InFlight(InFlight)) i_displace_vertex (
    .clk_i,
    .rst_ni,
    .map_i(regs_i.map),
    .regs_i(regs_i.displace),
    .in_valid_i(made_fire && ask_maps),
    .in_ready_o(displace_in_ready),
    .in_i('{u: made.u, n: made.n, p: made.p}),
    .quad_req_valid_o(place_req_valid_o),
    .quad_req_ready_i(place_req_ready_i),
    .quad_req_o(place_req_o),
    .quad_rsp_valid_i(place_rsp_valid_i),
    .quad_rsp_i(place_rsp_i),
    .out_valid_o(displaced_valid),
    .out_ready_i(displaced_ready),
    .out_o(displaced)
  );
  new_vertex_t waiting;
  logic        waiting_valid, waiting_leave;
  logic [$clog2(InFlight+65)-1:0] unused_waiting_count;
  stream_fifo #(.T(new_vertex_t), .Depth(InFlight + 64)) i_waiting (
    .clk_i,
    .rst_ni,
    .in_valid_i(made_fire),
    .in_ready_o(waiting_ready),
    .in_i(made),
    .out_valid_o(waiting_valid),
    .out_ready_i(waiting_leave),
    .out_o(waiting),
    .count_o(unused_waiting_count)
  );

  // ---- join, and the decision
  logic wait_maps, last_valid, last_ready, back_ready;
  assign wait_maps = needed(waiting, regs_i.pass);
  assign last_valid = waiting_valid && ((normal_valid && displaced_valid) || !wait_maps);
  assign last_ready = back_ready && first;
  assign waiting_leave = last_valid && last_ready;
  assign normal_ready = waiting_leave && wait_maps;
  assign displaced_ready = waiting_leave && wait_maps;

  lane_out_t back_data;
  edge_back #(.Clocks(VertexClocks)) i_back (
    .clk_i,
    .first_i(first),
    .regs_i,
    .in_i(waiting),
    .normal_i(normal),
    .displaced_i(displaced),
    .out_o(back_data)
  );
  stream_pipe #(.T(lane_out_t), .Latency(latency_pkg::edge_back(VertexClocks))) i_back_pipe (
    .clk_i,
    .rst_ni,
    .in_valid_i(last_valid && first),
    .in_ready_o(back_ready),
    .data_i(back_data),
    .out_valid_o,
    .out_ready_i,
    .out_o
  );
endmodule
