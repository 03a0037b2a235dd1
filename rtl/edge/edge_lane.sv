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
//   latency 175 clocks with one a vertex, and those of the table's and of the map's memory; initiation interval VertexClocks where the
//   memories deliver: an edge takes 12/ReadsPerClock clocks of the table and ceil(samples/SamplesPerClock) of the map when those tests are
//   on. Registered: all outputs, in_ready_o but for an AND; within, a join waits until all its parts have something. Nothing is dropped,
//   everything can stall.
//
//   in --[edge_tests]--+--[new_vertex]--[edge_maps]--[edge_back]--+-- out
//                      |                     |           |        |
//                      |                     +--its base-)--------+
//                      +--[FIFO: what was said]----------+
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
  localparam int unsigned NewLatency = latency_pkg::new_vertex(VertexClocks);
  localparam int unsigned BackLatency = latency_pkg::edge_back(VertexClocks);
  localparam int unsigned WaitingDepth = InFlight + 64;
  localparam int unsigned BaseDepth = WaitingDepth + BackLatency / VertexClocks + 9;

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

  // ---- the tests before there is a vertex
  weighted_t joined;
  judged_t   joined_judged;
  logic      joined_valid, joined_ready, new_ready, judged_ready;
  edge_tests #(
    .ReadsPerClock(ReadsPerClock), .SamplesPerClock(SamplesPerClock), .InFlight(InFlight)
  ) i_tests (
    .clk_i,
    .rst_ni,
    .regs_i,
    .in_valid_i,
    .in_ready_o,
    .in_i,
    .table_req_valid_o,
    .table_req_ready_i,
    .table_req_o,
    .table_rsp_valid_i,
    .table_rsp_i,
    .quad_req_valid_o,
    .quad_req_ready_i,
    .quad_req_o,
    .quad_req_mask_o,
    .quad_rsp_valid_i,
    .quad_rsp_i,
    .out_valid_o(joined_valid),
    .out_ready_i(joined_ready),
    .weighted_o(joined),
    .judged_o(joined_judged)
  );
  assign joined_ready = new_ready && judged_ready && first;

  // ---- the new vertex
  new_vertex_t made_data, made;
  logic        made_valid, made_ready;
  new_vertex #(.Clocks(VertexClocks)) i_new_vertex (
    .clk_i, .first_i(first), .in_i(joined), .out_o(made_data)
  );
  stream_pipe #(.T(new_vertex_t), .Latency(NewLatency)) i_new_pipe (
    .clk_i,
    .rst_ni,
    .in_valid_i(joined_valid && judged_ready && first),
    .in_ready_o(new_ready),
    .data_i(made_data),
    .out_valid_o(made_valid),
    .out_ready_i(made_ready),
    .out_o(made)
  );

  // What was said waits for N'.
  judged_t judged;
  logic    back_fire, unused_judged_valid;
  localparam int unsigned ToNormal = latency_pkg::bump(VertexClocks);
  localparam int unsigned JudgedDepth = NewLatency + WaitingDepth + ToNormal / VertexClocks + 12;
  logic [ToNormal-1:0] bumping_q;
  logic [$clog2(JudgedDepth+1)-1:0] unused_judged_count;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) bumping_q <= '0;
    else bumping_q <= {bumping_q[ToNormal-2:0], back_fire};
  end
  stream_fifo #(.T(judged_t), .Depth(JudgedDepth)) i_judged (
    .clk_i, .rst_ni,
    .in_valid_i(joined_valid && new_ready && first),
    .in_ready_o(judged_ready),
    .in_i(joined_judged),
    .out_valid_o(unused_judged_valid),
    .out_ready_i(bumping_q[ToNormal-1]),
    .out_o(judged),
    .count_o(unused_judged_count)
  );

  // ---- the maps at the new vertex, where one is needed
  waiting_t             waiting;
  normal_sampler_out_t  normal;
  displace_vertex_out_t displaced;
  base_frame_t          base;
  logic last_valid, last_ready, back_ready, seen_valid;
  edge_maps #(
    .InFlight(InFlight), .WaitingDepth(WaitingDepth), .BaseDepth(BaseDepth)
  ) i_maps (
    .clk_i,
    .rst_ni,
    .map_i(regs_i.map),
    .displace_i(regs_i.displace),
    .in_valid_i(made_valid),
    .in_ready_o(made_ready),
    .in_i(made),
    .place_req_valid_o,
    .place_req_ready_i,
    .place_req_o,
    .place_rsp_valid_i,
    .place_rsp_i,
    .normal_req_valid_o,
    .normal_req_ready_i,
    .normal_req_o,
    .normal_rsp_valid_i,
    .normal_rsp_i,
    .out_valid_o(last_valid),
    .out_ready_i(last_ready),
    .waiting_o(waiting),
    .normal_o(normal),
    .displaced_o(displaced),
    .base_leaves_i(seen_valid && out_ready_i),
    .base_o(base)
  );

  // ---- the decision
  assign last_ready = back_ready && first;
  assign back_fire = last_valid && last_ready;

  seen_vertex_t seen_data, seen;
  edge_back #(.Clocks(VertexClocks)) i_back (
    .clk_i,
    .first_i(first),
    .regs_i,
    .in_i(waiting),
    .normal_i(normal),
    .displaced_i(displaced),
    .judged_i(judged),
    .out_o(seen_data)
  );
  stream_pipe #(.T(seen_vertex_t), .Latency(BackLatency)) i_back_pipe (
    .clk_i,
    .rst_ni,
    .in_valid_i(last_valid && first),
    .in_ready_o(back_ready),
    .data_i(seen_data),
    .out_valid_o(seen_valid),
    .out_ready_i,
    .out_o(seen)
  );

  assign out_valid_o = seen_valid;
  always_comb begin
    out_o.counts = seen.counts;
    out_o.split = seen.split;
    out_o.m = '{
        transformed: 1'b1,
        displaced: 1'b1,
        away: seen.away,
        screen_n: seen.screen_n,
        behind: seen.behind,
        w: seen.w,
        screen: seen.screen,
        displaced_n: seen.displaced_n,
        displaced_p: seen.displaced_p,
        u: base.u,
        t: base.t,
        n: base.n,
        p: base.p
    };
  end
endmodule
