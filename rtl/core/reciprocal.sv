// reciprocal: 1 / x, rounded half up to Q bits, saturated: the divider with a constant numerator.
//   r = floor(2^Shift / x + 1/2)          contract: hls/core/reciprocal.hpp
//   in    x_i           D bits, unsigned
//   out   reciprocal_o  Q bits, unsigned;  clipped_o  it did not fit (x = 0 gives the largest value and counts)
//   Shift = fraction of the reciprocal + that of x
//
//   latency Q + 3, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: every stage and the outputs
module reciprocal #(
  parameter int unsigned D = 20,
  parameter int unsigned Q = 29,
  parameter int unsigned Shift = 28
) (
  input  logic         clk_i,
  input  logic [D-1:0] x_i,
  output logic [Q-1:0] reciprocal_o,
  output logic         clipped_o
);
  divide #(.N(1), .NSigned(1'b0), .D(D), .Q(Q), .QSigned(1'b0), .Shift(Shift)) i_divide (
    .clk_i, .num_i(1'b1), .den_i(x_i), .quotient_o(reciprocal_o), .clipped_o
  );
endmodule
