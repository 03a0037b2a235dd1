// edge_lane_cover: what scenes are to reach in a lane: each test deciding alone, vertices that saturate, and every stage that waits for
// another.
//   bound into edge_lane; the points see words that move, or wait, at the clock
module edge_lane_cover
  import formats_pkg::*;
  import surface_pkg::*;
  import edge_pkg::*;
  import lane_pkg::*;
(
  input logic         clk_i,
  input logic         rst_ni,
  // the new vertex
  input logic         joined_valid,
  input logic         joined_ready,
  // the second join
  input logic         last_valid,
  input logic         last_ready,
  // out
  input logic         out_valid_o,
  input logic         out_ready_i,
  input lane_out_t    out_o
);
  lane_counts_t             counts;
  logic                     leaves, splits, passed;
  assign counts = out_o.counts;
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

  // ---- vertices that enter the mesh
  vertex_away: cover property (@(posedge clk_i) leaves && counts.vertex && out_o.m.away);
  vertex_saturates: cover property (@(posedge clk_i) leaves && counts.saturations == 2'd1);
  vertex_and_normal_saturate: cover property (@(posedge clk_i) leaves
                                                               && counts.saturations == 2'd2);
  screen_saturates: cover property (@(posedge clk_i) leaves && counts.screen_saturation);
  a_vector_vanishes: cover property (@(posedge clk_i) leaves && counts.zero_vectors == 2'd1);
  two_vectors_vanish: cover property (@(posedge clk_i) leaves && counts.zero_vectors == 2'd2);

  // ---- waiting
  joined_waits: cover property (@(posedge clk_i) rst_ni && joined_valid && !joined_ready);
  last_waits: cover property (@(posedge clk_i) rst_ni && last_valid && !last_ready);
  out_waits: cover property (@(posedge clk_i) rst_ni && out_valid_o && !out_ready_i);
endmodule

bind edge_lane edge_lane_cover i_cover (.*);
