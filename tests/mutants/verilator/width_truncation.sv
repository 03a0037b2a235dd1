// rejected: width, unusedsignal
module width_truncation
  import formats_pkg::*;
(
  input  logic    clk_i,
  input  height_t a_i,
  output unit_t   y_o
);
  always_ff @(posedge clk_i) y_o <= a_i;
endmodule
