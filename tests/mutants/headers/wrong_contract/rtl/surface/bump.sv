// rejected: header, contract
// bump: tilts a normal.        contract: hls/surface/displace.hpp
//   latency 1, initiation interval 1; registered: y_o
module bump (
  input  logic clk_i,
  input  logic x_i,
  output logic y_o
);
  always_ff @(posedge clk_i) y_o <= x_i;
endmodule
