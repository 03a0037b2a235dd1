// rejected: latch
module inferred_latch (
  input  logic       take_i,
  input  logic [3:0] in_i,
  output logic [3:0] out_o
);
  always_comb begin
    if (take_i) out_o = in_i;
  end
endmodule
