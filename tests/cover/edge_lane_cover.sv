// edge_lane_cover: what scenes are to reach in a lane: each test deciding alone, vt and ct stopping alone, ends behind the eye, vertices
// that saturate, and every stage that waits for another.
//   bound into edge_lane; the points see words that move, or wait, at the clock
module edge_lane_cover
  import formats_pkg::*;
  import surface_pkg::*;
  import edge_pkg::*;
  import lane_pkg::*;
(
  input logic         clk_i,
  input logic         rst_ni,
  input engine_regs_t regs_i,
  // edges past the tests that read no map
  input logic         front_valid,
  input logic         front_fire,
  input tested_t      front,
  input logic         ask_sht,
  input logic         ask_pt,
  input logic         sht_in_ready,
  input logic         pt_in_ready,
  input logic         beside_ready,
  // the first join
  input logic         beside_valid,
  input logic         wait_sht,
  input logic         wait_pt,
  input logic         sht_valid,
  input logic         sht_ready,
  input logic         pt_valid,
  input logic         pt_ready,
  input logic         joined_valid,
  input logic         joined_ready,
  // the maps at the new vertex
  input logic         made_valid,
  input logic         ask_maps,
  input logic         waiting_ready,
  input logic         normal_in_ready,
  input logic         displace_in_ready,
  // the second join
  input logic         waiting_valid,
  input logic         wait_maps,
  input logic         normal_valid,
  input logic         displaced_valid,
  input logic         last_valid,
  input logic         last_ready,
  // out
  input logic         out_valid_o,
  input logic         out_ready_i,
  input lane_out_t    out_o
);
  pass_or_tessellate_regs_t use_test;
  lane_counts_t             counts;
  logic                     asks, leaves, splits, passed;
  assign use_test = regs_i.pass;
  assign counts = out_o.counts;
  assign asks = rst_ni && front_fire && !front.work.place;
  assign leaves = rst_ni && out_valid_o && out_ready_i;
  assign splits = leaves && out_o.split;

  // ---- tests
  logic [3:0] true_tests;
  assign true_tests = {counts.ht, counts.pt, counts.sht, counts.nt};
  assign passed = leaves && counts.edge_test && !counts.vt && !counts.ct;
  nt_alone_decides: cover property (@(posedge clk_i) splits && true_tests == 4'b0001);
  sht_alone_decides: cover property (@(posedge clk_i) splits && true_tests == 4'b0010);
  pt_alone_decides: cover property (@(posedge clk_i) splits && true_tests == 4'b0100);
  ht_alone_decides: cover property (@(posedge clk_i) splits && true_tests == 4'b1000);
  all_agree: cover property (@(posedge clk_i) splits && true_tests == 4'b1111);
  none_decides: cover property (@(posedge clk_i) passed && !out_o.split && true_tests == 4'b0000);

  logic vt_lets, ct_lets;
  assign vt_lets = front.vt || !use_test.use_vt;
  assign ct_lets = front.ct || !use_test.use_ct;
  vt_alone_stops: cover property (@(posedge clk_i) asks && !vt_lets && ct_lets);
  ct_alone_stops: cover property (@(posedge clk_i) asks && !ct_lets && vt_lets);
  both_stop: cover property (@(posedge clk_i) asks && !vt_lets && !ct_lets);
  neither_stops: cover property (@(posedge clk_i) asks && front.vt && front.ct
                                 && use_test.use_vt && use_test.use_ct);

  // ---- the eye plane
  logic a_behind, b_behind;
  assign a_behind = front.work.a.behind;
  assign b_behind = front.work.b.behind;
  first_end_behind: cover property (@(posedge clk_i) asks && a_behind && !b_behind);
  second_end_behind: cover property (@(posedge clk_i) asks && !a_behind && b_behind);
  both_ends_behind: cover property (@(posedge clk_i) asks && a_behind && b_behind);
  vertex_away: cover property (@(posedge clk_i) leaves && counts.vertex && out_o.m.away);

  // ---- vertices that enter the mesh
  vertex_saturates: cover property (@(posedge clk_i) leaves && counts.saturations == 2'd1);
  vertex_and_normal_saturate: cover property (@(posedge clk_i) leaves
                                                               && counts.saturations == 2'd2);
  screen_saturates: cover property (@(posedge clk_i) leaves && counts.screen_saturation);
  a_vector_vanishes: cover property (@(posedge clk_i) leaves && counts.zero_vectors == 2'd1);
  two_vectors_vanish: cover property (@(posedge clk_i) leaves && counts.zero_vectors == 2'd2);

  // ---- waiting
  sht_refuses: cover property (@(posedge clk_i) rst_ni && front_valid && ask_sht && !sht_in_ready);
  pt_refuses: cover property (@(posedge clk_i) rst_ni && front_valid && ask_pt && !pt_in_ready);
  beside_full: cover property (@(posedge clk_i) rst_ni && front_valid && !beside_ready);
  waits_for_sht: cover property (@(posedge clk_i) rst_ni && beside_valid && wait_sht && !sht_valid);
  waits_for_pt: cover property (@(posedge clk_i) rst_ni && beside_valid && wait_pt && !pt_valid);
  sht_waits: cover property (@(posedge clk_i) rst_ni && sht_valid && !sht_ready);
  pt_waits: cover property (@(posedge clk_i) rst_ni && pt_valid && !pt_ready);
  joined_waits: cover property (@(posedge clk_i) rst_ni && joined_valid && !joined_ready);
  normal_refuses: cover property (@(posedge clk_i) rst_ni && made_valid && ask_maps
                                  && !normal_in_ready);
  displace_refuses: cover property (@(posedge clk_i) rst_ni && made_valid && ask_maps
                                    && !displace_in_ready);
  waiting_full: cover property (@(posedge clk_i) rst_ni && made_valid && !waiting_ready);
  waits_for_normal: cover property (@(posedge clk_i) rst_ni && waiting_valid && wait_maps
                                    && !normal_valid);
  waits_for_displaced: cover property (@(posedge clk_i) rst_ni && waiting_valid && wait_maps
                                       && !displaced_valid);
  last_waits: cover property (@(posedge clk_i) rst_ni && last_valid && !last_ready);
  out_waits: cover property (@(posedge clk_i) rst_ni && out_valid_o && !out_ready_i);
endmodule

bind edge_lane edge_lane_cover i_cover (.*);
