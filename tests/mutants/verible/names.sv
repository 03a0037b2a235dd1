// rejected: port name suffix, parameter name style, generate label prefix
module names #(
  parameter int unsigned word_bits = 4
) (
  input  logic                 clock,
  input  logic [word_bits-1:0] x_i,
  output logic [word_bits-1:0] y_o
);
  for (genvar i = 0; i < word_bits; i++) begin : bits
    always_ff @(posedge clock) y_o[i] <= x_i[i];
  end
endmodule
