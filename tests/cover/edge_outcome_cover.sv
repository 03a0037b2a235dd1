// edge_outcome_cover: a triangle that waits for the tessellate whose turn it is, also while another one is free.
//   bound into edge_outcome; the points see words that wait at the clock
module edge_outcome_cover #(
  parameter int unsigned Lanes = 1
) (
  input logic             clk_i,
  input logic             rst_ni,
  input logic             in_valid_i,
  input logic             in_ready_o,
  input logic [Lanes-1:0] turn,
  input logic [Lanes-1:0] ready,
  input logic [Lanes-1:0] child_valid,
  input logic [Lanes-1:0] child_ready
);
  logic waits;
  assign waits = rst_ni && in_valid_i && !in_ready_o;
  in_waits: cover property (@(posedge clk_i) waits);
  turn_held: cover property (@(posedge clk_i) waits && |(ready & ~turn));
  child_waits: cover property (@(posedge clk_i) rst_ni && |(child_valid & ~child_ready));
endmodule

bind edge_outcome edge_outcome_cover #(
  .Lanes(Lanes)
) i_cover (.*);
