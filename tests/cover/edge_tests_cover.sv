// edge_tests_cover: what scenes are to reach in the tests before there is a vertex: vt and ct stopping alone, ends behind the eye, and every
// stage that waits for another.
//   bound into edge_tests; the points see words that move, or wait, at the clock
module edge_tests_cover
  import lane_pkg::*;
  import edge_pkg::*;
(
  input logic         clk_i,
  input logic         rst_ni,
  input engine_regs_t regs_i,
  input logic         in_valid_i,
  input logic         in_ready_o,
  input lane_in_t     in_i,
  input logic         front_in_ready,
  input logic         ends_ready,
  // edges past the tests that read no map
  input logic         front_valid,
  input logic         front_fire,
  input tested_t      front,
  input logic         ask_sht,
  input logic         ask_pt,
  input logic         sht_in_ready,
  input logic         pt_in_ready,
  input logic         beside_ready,
  // the join
  input logic         near_beside_valid,
  input logic         wait_sht,
  input logic         wait_pt,
  input logic         near_sht_valid,
  input logic         near_pt_valid,
  input logic         sht_valid,
  input logic         sht_ready,
  input logic         pt_valid,
  input logic         pt_ready,
  input logic         out_valid_o,
  input logic         out_ready_i
);
  pass_or_tessellate_regs_t use_test;
  logic                     enters, asks;
  assign use_test = regs_i.pass;
  assign enters = rst_ni && in_valid_i && in_ready_o && !in_i.place;
  assign asks = rst_ni && front_fire && !front.place;

  // ---- tests
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
  assign a_behind = in_i.a.behind;
  assign b_behind = in_i.b.behind;
  first_end_behind: cover property (@(posedge clk_i) enters && a_behind && !b_behind);
  second_end_behind: cover property (@(posedge clk_i) enters && !a_behind && b_behind);
  both_ends_behind: cover property (@(posedge clk_i) enters && a_behind && b_behind);

  // ---- waiting
  front_full: cover property (@(posedge clk_i) rst_ni && in_valid_i && !front_in_ready);
  ends_full: cover property (@(posedge clk_i) rst_ni && in_valid_i && !ends_ready);
  sht_refuses: cover property (@(posedge clk_i) rst_ni && front_valid && ask_sht && !sht_in_ready);
  pt_refuses: cover property (@(posedge clk_i) rst_ni && front_valid && ask_pt && !pt_in_ready);
  beside_full: cover property (@(posedge clk_i) rst_ni && front_valid && !beside_ready);
  waits_for_sht: cover property (@(posedge clk_i) rst_ni && near_beside_valid && wait_sht
                                 && !near_sht_valid);
  waits_for_pt: cover property (@(posedge clk_i) rst_ni && near_beside_valid && wait_pt
                                && !near_pt_valid);
  sht_waits: cover property (@(posedge clk_i) rst_ni && sht_valid && !sht_ready);
  pt_waits: cover property (@(posedge clk_i) rst_ni && pt_valid && !pt_ready);
  out_waits: cover property (@(posedge clk_i) rst_ni && out_valid_o && !out_ready_i);
endmodule

bind edge_tests edge_tests_cover i_cover (
  .wait_sht(near_beside.ask_sht), .wait_pt(near_beside.ask_pt), .*
);
