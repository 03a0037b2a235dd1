// tessellate_cover: what triangles are to reach in tessellate: both diagonals of each two splits, the tie between them, and every place
// where a triangle can be kept waiting.
//   bound into tessellate; the points see words that move, or wait, at the clock
module tessellate_cover (
  input logic       clk_i,
  input logic       rst_ni,
  input logic       in_valid_i,
  input logic       places_left,
  input logic       asking,
  input logic       order_valid,
  input logic       known,
  input logic       go,
  input logic       ends,
  input logic       first,
  input logic [2:0] split_i,
  input logic       out_valid_o,
  input logic       out_ready_i,
  // a decision, and the difference of the squared diagonals of a clock before
  input logic       decides_i,
  input logic       decision,
  input logic       equal_i
);
  // ---- diagonals of two splits, when the last child goes
  logic two, equal_q;
  assign two = rst_ni && go && ends && $countones(split_i) == 2;
  first_diagonal_of_011: cover property (@(posedge clk_i) two && first && split_i == 3'b011);
  first_diagonal_of_110: cover property (@(posedge clk_i) two && first && split_i == 3'b110);
  first_diagonal_of_101: cover property (@(posedge clk_i) two && first && split_i == 3'b101);
  other_diagonal_of_011: cover property (@(posedge clk_i) two && !first && split_i == 3'b011);
  other_diagonal_of_110: cover property (@(posedge clk_i) two && !first && split_i == 3'b110);
  other_diagonal_of_101: cover property (@(posedge clk_i) two && !first && split_i == 3'b101);
  always_ff @(posedge clk_i) equal_q <= equal_i;
  tie_for_the_first: cover property (@(posedge clk_i) rst_ni && decides_i && equal_q && decision);
  tie_for_the_other: cover property (@(posedge clk_i) rst_ni && decides_i && equal_q && !decision);

  // ---- what waits
  six_full: cover property (@(posedge clk_i) rst_ni && in_valid_i && !places_left);
  diagonal_busy: cover property (@(posedge clk_i) rst_ni && in_valid_i && places_left && asking);
  child_undecided: cover property (@(posedge clk_i) rst_ni && order_valid && !known);
  out_waits: cover property (@(posedge clk_i) rst_ni && out_valid_o && !out_ready_i);
endmodule

bind tessellate tessellate_cover i_cover (
  .split_i(order.split),
  .decides_i(i_decisions.travelling_q[$bits(i_decisions.travelling_q)-1]),
  .equal_i(i_diagonal.s4_sum_q == '0),
  .*
);
