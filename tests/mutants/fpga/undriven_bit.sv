// rejected: undriven
module undriven_bit (
  input  logic       clk_i,
  input  logic [2:0] in_i,
  output logic [3:0] out_o
);
  logic [3:0] word;
  assign word[2:0] = in_i;
  always_ff @(posedge clk_i) out_o <= word;
endmodule
