// rejected: module port
module positional_ports (
  input  logic clk_i,
  input  logic x_i,
  output logic y_o
);
  delay #(.Stages(2)) i_delay (clk_i, x_i, y_o);
endmodule
