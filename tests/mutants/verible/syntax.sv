// rejected: syntax error
module syntax (
  input  logic x_i
  output logic y_o
);
  assign y_o = x_i;
endmodule
