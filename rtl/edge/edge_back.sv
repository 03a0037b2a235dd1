// edge_back: what a lane does once the maps have been read at the new vertex: N', the tests on normals, the way to the screen, and the
// decision.
//   contract: test_edge and place of hls/edge/engine.hpp, after the samplers
//   in    in_i      the new vertex's base frame
//         normal_i  its sample of the normal map;  displaced_i  its P'
//         judged_i  what the earlier tests said, and N' of the ends: comes when N' does, bump(Clocks) of latency_pkg later
//   out   out_o     the vertex, complete with P'_s and N'_s; whether the edge splits there; what to count
//
//   parameter  Clocks  that a vertex takes, 1 or 3: see the units
//   in         first_i with three clocks: a vertex comes in; the next every three clocks, or later by a multiple of three
//
//   latency 37, or 42 with three clocks: that of bump, then of the tests and pass_or_tessellate or of transform_normal, whichever is longer,
//   and no less than that of transform (latency_pkg); initiation interval Clocks; a pure pipeline, no reset on data; registered: every
//   stage; out_o is a few gates behind the last
//
//   m --[bump]-- N' --+--[normal_test, highlight_test]--[pass_or_tessellate]-- split
//                     +--[transform_normal]-- N'_s
//   P' --[transform]-- P'_s
module edge_back
  import formats_pkg::*;
  import surface_pkg::*;
  import edge_pkg::*;
  import lane_pkg::*;
  import latency_pkg::*;
#(
  parameter int unsigned Clocks = 1,
  localparam int unsigned Latency = latency_pkg::edge_back(Clocks)
) (
  input  logic                 clk_i,
  input  logic                 first_i,
  input  engine_regs_t         regs_i,
  input  waiting_t             in_i,
  input  normal_sampler_out_t  normal_i,
  input  displace_vertex_out_t displaced_i,
  input  judged_t              judged_i,
  output seen_vertex_t         out_o
);
  localparam int unsigned ToNormal = latency_pkg::bump(Clocks);
  localparam int unsigned ToHighlight = latency_pkg::highlight_test(Clocks);
  localparam int unsigned ToScreen = latency_pkg::transform(Clocks);
  localparam int unsigned ToScreenNormal = latency_pkg::transform_normal(Clocks);

  // N', and what comes after it. With three clocks a vertex is at the same of the three at every place, all the time.
  logic first_after;
  delay #(.Stages(ToNormal % Clocks)) i_first_after (.clk_i, .x_i(first_i), .y_o(first_after));
  bump_out_t s0_bump, s1_bump;
  bump #(.Clocks(Clocks)) i_bump (
    .clk_i, .first_i, .in_i('{m: normal_i.n, t: in_i.t, n: in_i.n}), .out_o(s0_bump)
  );
  delay #(.T(bump_out_t), .Stages(Latency - ToNormal)) i_bump_later (
    .clk_i, .x_i(s0_bump), .y_o(s1_bump)
  );

  localparam int unsigned TestsOnly = longer(NormalTest, ToHighlight);
  localparam int unsigned Tests = TestsOnly + PassOrTessellate;
  normal_test_out_t s0_nt, s1_nt, s2_nt;
  normal_test i_nt (
    .clk_i,
    .regs_i(regs_i.normal),
    .in_i('{n12: s0_bump.n, n2: judged_i.n2, n1: judged_i.n1}),
    .out_o(s0_nt)
  );
  delay #(.T(normal_test_out_t), .Stages(TestsOnly - NormalTest)) i_nt_later (
    .clk_i, .x_i(s0_nt), .y_o(s1_nt)
  );
  highlight_test_out_t s0_ht, s1_ht, s2_ht;
  highlight_test #(.Clocks(Clocks)) i_ht (
    .clk_i,
    .first_i(first_after),
    .regs_i(regs_i.highlight),
    .in_i('{n12: s0_bump.n, n2: judged_i.n2, n1: judged_i.n1}),
    .out_o(s0_ht)
  );
  delay #(.T(highlight_test_out_t), .Stages(TestsOnly - ToHighlight)) i_ht_later (
    .clk_i, .x_i(s0_ht), .y_o(s1_ht)
  );

  // What was said before, beside it.
  typedef struct packed {
    logic        [4:0] samples;
    generation_t       generation;
    logic              place;
    logic              pt;
    logic              sht;
    logic              ct;
    logic              vt;
  } said_t;
  said_t s0_said, s1_said, s2_said;
  assign s0_said = '{
      samples: judged_i.samples,
      generation: judged_i.generation,
      place: judged_i.place,
      pt: judged_i.pt,
      sht: judged_i.sht,
      ct: judged_i.ct,
      vt: judged_i.vt
  };
  delay #(.T(said_t), .Stages(TestsOnly)) i_said (.clk_i, .x_i(s0_said), .y_o(s1_said));
  delay #(.T(said_t), .Stages(Latency - ToNormal - TestsOnly)) i_said_end (
    .clk_i, .x_i(s1_said), .y_o(s2_said)
  );
  pass_or_tessellate_out_t s1_split, s2_split;
  pass_or_tessellate i_split (
    .clk_i,
    .regs_i(regs_i.pass),
    .in_i('{
        settled: s1_said.place,
        generation: s1_said.generation,
        ct: s1_said.ct,
        vt: s1_said.vt,
        ht: s1_ht.ht,
        pt: s1_said.pt,
        sht: s1_said.sht,
        nt: s1_nt.nt
    }),
    .out_o(s1_split)
  );
  delay #(.T(pass_or_tessellate_out_t), .Stages(Latency - ToNormal - Tests)) i_split_later (
    .clk_i, .x_i(s1_split), .y_o(s2_split)
  );
  delay #(.T(normal_test_out_t), .Stages(Latency - ToNormal - TestsOnly)) i_nt_end (
    .clk_i, .x_i(s1_nt), .y_o(s2_nt)
  );
  delay #(.T(highlight_test_out_t), .Stages(Latency - ToNormal - TestsOnly)) i_ht_end (
    .clk_i, .x_i(s1_ht), .y_o(s2_ht)
  );

  // To the screen.
  position_t [2:0] s0_p;
  delay #(.T(position_t [2:0]), .Stages(ToNormal)) i_p (.clk_i, .x_i(displaced_i.p), .y_o(s0_p));
  transform_normal_out_t s0_normal, s1_normal;
  transform_normal #(.Clocks(Clocks)) i_transform_normal (
    .clk_i,
    .first_i(first_after),
    .regs_i(regs_i.transform_normal),
    .in_i('{n: s0_bump.n, p: s0_p}),
    .out_o(s0_normal)
  );
  delay #(.T(transform_normal_out_t), .Stages(Latency - ToNormal - ToScreenNormal)) i_normal_later (
    .clk_i, .x_i(s0_normal), .y_o(s1_normal)
  );
  transform_out_t s0_seen, s1_seen;
  transform #(.Clocks(Clocks)) i_transform (
    .clk_i, .first_i, .regs_i(regs_i.transform), .in_i('{p: displaced_i.p}), .out_o(s0_seen)
  );
  delay #(.T(transform_out_t), .Stages(Latency - ToScreen)) i_seen_later (
    .clk_i, .x_i(s0_seen), .y_o(s1_seen)
  );

  // What came in, beside its results.
  logic                 [1:0] zeros;
  displace_vertex_out_t       displaced;
  delay #(.T(logic [1:0]), .Stages(Latency)) i_zeros (.clk_i, .x_i(in_i.zeros), .y_o(zeros));
  delay #(.T(displace_vertex_out_t), .Stages(Latency)) i_displaced (
    .clk_i, .x_i(displaced_i), .y_o(displaced)
  );

  logic stays, past_vt, past;
  assign stays = s2_said.place || s2_split.split;
  // Past vt and ct, the tests that are asked first.
  assign past_vt = !s2_said.place && (s2_said.vt || !regs_i.pass.use_vt);
  assign past = past_vt && (s2_said.ct || !regs_i.pass.use_ct);
  always_comb begin
    out_o = '0;
    out_o.displaced_p = displaced.p;
    out_o.displaced_n = s1_bump.n;
    out_o.screen = s1_seen.screen;
    out_o.w = s1_seen.w;
    out_o.behind = s1_seen.behind;
    out_o.screen_n = s1_normal.n;
    out_o.away = s1_normal.away;
    out_o.split = s2_split.split;
    out_o.counts.edge_test = !s2_said.place;
    out_o.counts.vt = !s2_said.place && regs_i.pass.use_vt && !s2_said.vt;
    out_o.counts.ct = past_vt && regs_i.pass.use_ct && !s2_said.ct;
    out_o.counts.nt = past && regs_i.pass.use_nt && s2_nt.nt;
    out_o.counts.sht = past && regs_i.pass.use_sht && s2_said.sht;
    out_o.counts.pt = past && regs_i.pass.use_pt && s2_said.pt;
    out_o.counts.ht = past && regs_i.pass.use_ht && s2_ht.ht;
    out_o.counts.vertex = stays;
    out_o.counts.saturations = stays ? 2'(displaced.saturated) + 2'(s1_bump.saturated) : 2'd0;
    out_o.counts.screen_saturation = stays && s1_seen.saturated;
    out_o.counts.zero_vectors = stays ? zeros + 2'(s1_bump.zero) : 2'd0;
    out_o.counts.table_read = past && regs_i.pass.use_sht;
    out_o.counts.profile_samples = past && regs_i.pass.use_pt ? s2_said.samples : 5'd0;
  end
endmodule
