// edge_tests: the tests that an edge goes through before there is a vertex on it, and where that one would stand.
//   contract: test_edge of hls/edge/engine.hpp, up to the new vertex
//   in    in_*       lane_in_t: an edge that is not settled, or a base vertex, which passes
//         table, quad  as in edge_lane
//   out   weighted_o, judged_o  what the new vertex is made of, and what the tests after it need; in the order of in_*
//
//   latency 14 clocks, 11 more than those of the tests on the maps where one is asked; initiation interval 1 where the memories deliver.
//   in_ready_o the AND of two registers; out_valid_o waits until all that is asked has an answer, and comes from registers. Nothing is
//   dropped.
//
//   in --+--[edge_front]--+--[summed_height_test]--+-- out
//        |                +--[profile_test]--------+
//        |                +--[FIFO]----------------+
//        +--[FIFO: the ends]-----------------------+
module edge_tests
  import formats_pkg::*;
  import memory_pkg::*;
  import edge_pkg::*;
  import lane_pkg::*;
  import latency_pkg::*;
#(
  parameter int unsigned ReadsPerClock = 12,
  parameter int unsigned SamplesPerClock = 4,
  parameter int unsigned InFlight = 128
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

  output logic      out_valid_o,
  input  logic      out_ready_i,
  output weighted_t weighted_o,
  output judged_t   judged_o
);
  localparam int unsigned FrontLatency = CalculateNewU + TexCoordTest;
  localparam int unsigned BesideDepth = InFlight + 64;

  // Is the edge past the tests that are asked first?
  function automatic logic past(logic place, logic vt, logic ct, pass_or_tessellate_regs_t regs);
    return !place && (vt || !regs.use_vt) && (ct || !regs.use_ct);
  endfunction

  // What is asked of the maps, and what came of it.
  typedef struct packed {
    logic [4:0] samples;
    logic       ct;
    logic       vt;
    logic       past;
    logic       ask_sht;
    logic       ask_pt;
  } asked_t;
  typedef struct packed {
    asked_t  asked;
    logic    sht;
    logic    pt;
    weight_t k;
  } said_t;

  // ---- the ends wait for the join; what is beside them there waits in the two FIFOs below
  base_edge_t ends_in, ends;
  logic front_in_ready, ends_ready, ends_valid, leave;
  assign in_ready_o = front_in_ready && ends_ready;
  assign ends_in = '{
      b: '{displaced_n: in_i.b.displaced_n, u: in_i.b.u, t: in_i.b.t, n: in_i.b.n, p: in_i.b.p},
      a: '{displaced_n: in_i.a.displaced_n, u: in_i.a.u, t: in_i.a.t, n: in_i.a.n, p: in_i.a.p},
      generation: in_i.generation,
      place: in_i.place
  };
  localparam int unsigned EndsDepth = BesideDepth + FrontLatency + 9;
  logic [$clog2(EndsDepth+1)-1:0] unused_ends_count;
  stream_fifo #(.T(base_edge_t), .Depth(EndsDepth)) i_ends (
    .clk_i,
    .rst_ni,
    .in_valid_i(in_valid_i && front_in_ready),
    .in_ready_o(ends_ready),
    .in_i(ends_in),
    .out_valid_o(ends_valid),
    .out_ready_i(leave),
    .out_o(ends),
    .count_o(unused_ends_count)
  );

  // ---- the tests without a memory
  tested_t front_data, front;
  logic    front_valid, front_ready;
  edge_front i_front (
    .clk_i, .map_i(regs_i.map), .regs_i(regs_i.view), .in_i, .out_o(front_data)
  );
  stream_pipe #(.T(tested_t), .Latency(FrontLatency)) i_front_pipe (
    .clk_i,
    .rst_ni,
    .in_valid_i(in_valid_i && ends_ready),
    .in_ready_o(front_in_ready),
    .data_i(front_data),
    .out_valid_o(front_valid),
    .out_ready_i(front_ready),
    .out_o(front)
  );

  // ---- the tests on the maps, side by side; every edge waits beside them, in order
  logic front_past, ask_sht, ask_pt;
  assign front_past = past(front.place, front.vt, front.ct, regs_i.pass);
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
    .in_i('{u12: front.u12, u2: front.u2, u1: front.u1}),
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
    .in_i('{forward: front.forward, u2: front.u2, u1: front.u1}),
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

  asked_t beside, beside_in;
  logic  beside_valid, beside_leaves;
  logic [$clog2(BesideDepth+1)-1:0] unused_beside_count;
  assign beside_in = '{
      samples: front.samples, ct: front.ct, vt: front.vt,
      past: front_past, ask_sht: ask_sht, ask_pt: ask_pt
  };
  stream_fifo #(.T(asked_t), .Depth(BesideDepth)) i_beside (
    .clk_i,
    .rst_ni,
    .in_valid_i(front_fire),
    .in_ready_o(beside_ready),
    .in_i(beside_in),
    .out_valid_o(beside_valid),
    .out_ready_i(beside_leaves),
    .out_o(beside),
    .count_o(unused_beside_count)
  );

  // ---- join: the place of the new vertex is known. What is joined comes from all over the device: a register on each side of it.
  logic near_sht_valid, near_pt_valid, near_beside_valid, said_ready, complete, meets;
  summed_height_test_out_t near_sht;
  profile_test_out_t       near_pt;
  asked_t                  near_beside;
  stream_register #(.T(summed_height_test_out_t)) i_near_sht (
    .clk_i, .rst_ni, .in_valid_i(sht_valid), .in_ready_o(sht_ready), .in_i(sht),
    .out_valid_o(near_sht_valid), .out_ready_i(meets && near_beside.ask_sht), .out_o(near_sht)
  );
  stream_register #(.T(profile_test_out_t)) i_near_pt (
    .clk_i, .rst_ni, .in_valid_i(pt_valid), .in_ready_o(pt_ready), .in_i(pt),
    .out_valid_o(near_pt_valid), .out_ready_i(meets && near_beside.ask_pt), .out_o(near_pt)
  );
  stream_register #(.T(asked_t)) i_near_beside (
    .clk_i, .rst_ni, .in_valid_i(beside_valid), .in_ready_o(beside_leaves), .in_i(beside),
    .out_valid_o(near_beside_valid), .out_ready_i(meets), .out_o(near_beside)
  );
  assign complete = near_beside_valid && (near_sht_valid || !near_beside.ask_sht)
                    && (near_pt_valid || !near_beside.ask_pt);
  assign meets = complete && said_ready;
  said_t said_in, said;
  always_comb begin
    said_in.asked = near_beside;
    said_in.sht = near_beside.ask_sht && near_sht.sht;
    said_in.pt = near_beside.ask_pt && near_pt.pt;
    said_in.k = near_beside.ask_pt ? near_pt.k : 5'd8;
  end
  stream_register #(.T(said_t)) i_said (
    .clk_i, .rst_ni,
    .in_valid_i(complete), .in_ready_o(said_ready), .in_i(said_in),
    .out_valid_o, .out_ready_i, .out_o(said)
  );
  // Its ends were there long before.
  assign leave = out_valid_o && out_ready_i;
  logic no_ends;
  assign no_ends = out_valid_o && !ends_valid;
  always_ff @(posedge clk_i) begin
    if (rst_ni) assert (!no_ends) else $error("edge_tests: an answer came before its edge");
  end

  always_comb begin
    judged_o.n1 = ends.a.displaced_n;
    judged_o.n2 = ends.b.displaced_n;
    judged_o.generation = ends.generation;
    judged_o.place = ends.place;
    judged_o.samples = said.asked.samples;
    judged_o.vt = said.asked.vt;
    judged_o.ct = said.asked.ct;
    judged_o.sht = said.sht;
    judged_o.pt = said.pt;
    weighted_o.work = ends;
    weighted_o.k = ends.place ? 5'd0 : said.k;
    // A test asks for its N', or splits here.
    weighted_o.needed = ends.place || (said.asked.past && (regs_i.pass.use_nt || regs_i.pass.use_ht
                                                           || said.sht || said.pt));
  end
endmodule
