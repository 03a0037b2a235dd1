// turn: turns a normal.
//   latency 1, initiation interval 1; the rest as bump.sv
module turn (
  input  logic clk_i,
  input  logic x_i,
  output logic y_o
);
  always_ff @(posedge clk_i) y_o <= x_i;
endmodule
