// rejected: header, latency, initiation interval
// bump: tilts a normal.
//   registered: y_o
module bump (
  input  logic clk_i,
  input  logic x_i,
  output logic y_o
);
  always_ff @(posedge clk_i) y_o <= x_i;
endmodule
