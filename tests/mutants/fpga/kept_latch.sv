// rejected: latch
module kept_latch (
  input  logic       clk_i,
  input  logic [3:0] in_i,
  output logic [3:0] out_o
);
  logic [3:0] kept;
  always_latch begin
    if (!clk_i) kept = in_i;
  end
  always_ff @(posedge clk_i) out_o <= kept;
endmodule
