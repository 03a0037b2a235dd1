// divide: numerator / denominator, rounded half up to Q bits, saturated.
//   quotient = floor(n 2^Shift / d + 1/2)          contract: hls/core/divide.hpp
//   in    num_i       N bits, signed if NSigned;  den_i  D bits, unsigned
//   out   quotient_o  Q bits, signed if QSigned;  clipped_o  it did not fit; d = 0 saturates by the sign of n and counts
//   Shift = fraction of the quotient - that of the numerator + that of the denominator, not negative
//
//   latency Q + 3, initiation interval 1; a pure pipeline, one quotient bit a stage; registered: every stage and the outputs
//
//   n, d --[s0 + d/2]--[s1 + d 2^(Q-1)]--[step 0]-- ... --[step Q-1]--[select]-- quotient
//
//   The half and the lowest quotient are added first, so that what is divided, u = n 2^Shift + floor(d/2) + d 2^(Q-1), has an
//   unsigned quotient of Q bits exactly where nothing clips: 0 <= u < d 2^Q. A zero denominator fails one of the two by itself.
//   The steps do not restore: below zero they add d, else they subtract it; the sign of the result is the quotient bit.
module divide #(
  parameter int unsigned N = 38,
  parameter bit NSigned = 1'b1,
  parameter int unsigned D = 28,
  parameter int unsigned Q = 22,
  parameter bit QSigned = 1'b1,
  parameter int unsigned Shift = 8
) (
  input  logic         clk_i,
  input  logic [N-1:0] num_i,
  input  logic [D-1:0] den_i,
  output logic [Q-1:0] quotient_o,
  output logic         clipped_o
);
  localparam int unsigned Top = N + Shift > D + Q ? N + Shift : D + Q;
  localparam int unsigned Wide = Top + 2;  // a sign, and the carry of the sum
  localparam int unsigned Narrow = (N + Shift > D ? N + Shift : D) + 2;

  // s0: n 2^Shift + floor(d/2)
  logic signed [N:0]        n;
  logic signed [Narrow-1:0] s0_sum_q;
  logic        [D-1:0]      s0_den_q;
  assign n = {NSigned & num_i[N-1], num_i};
  always_ff @(posedge clk_i) begin
    s0_sum_q <= (Narrow'(n) <<< Shift) + signed'(Narrow'(den_i[D-1:1]));
    s0_den_q <= den_i;
  end

  // s1: + d 2^(Q-1), which makes the least signed quotient 0
  logic signed [Wide-1:0] s1_sum_q;
  logic        [D-1:0]    den_q[Q];
  if (QSigned) begin : gen_signed
    always_ff @(posedge clk_i) s1_sum_q <= Wide'(s0_sum_q) + (signed'(Wide'(s0_den_q)) <<< (Q - 1));
  end else begin : gen_unsigned
    always_ff @(posedge clk_i) s1_sum_q <= Wide'(s0_sum_q);
  end
  always_ff @(posedge clk_i) den_q[0] <= s0_den_q;

  // The steps: a remainder in [-d, d); the word holds the bits of u that are left, and the quotient's, which take their places.
  logic [D:0]   remainder_q[Q];
  logic [Q-1:0] word_q     [Q+1];
  assign remainder_q[0] = s1_sum_q[Q+:D+1];
  assign word_q[0] = s1_sum_q[Q-1:0];
  for (genvar i = 0; i < Q; i++) begin : gen_step
    logic         add;
    logic [D+1:0] sum;
    // a - b is a + ~b + 1: the lowest bit makes the carry.
    assign add = remainder_q[i][D];
    assign sum = {remainder_q[i][D-1:0], word_q[i][Q-1], !add}
               + {{1'b0, den_q[i]} ^ {(D + 1) {!add}}, !add};
    always_ff @(posedge clk_i) word_q[i+1] <= {word_q[i][Q-2:0], !sum[D+1]};
    if (i < Q - 1) begin : gen_next
      always_ff @(posedge clk_i) begin
        remainder_q[i+1] <= sum[D+1:1];
        den_q[i+1] <= den_q[i];
      end
      logic unused_carry;
      assign unused_carry = sum[0];
    end else begin : gen_last
      logic unused_remainder;
      assign unused_remainder = ^sum[D:0];
    end
  end

  // Beside step 0: does u lie beyond either end? Where it is negative, high means nothing.
  typedef struct packed {
    logic low;
    logic high;
  } ends_t;
  ends_t clip_q, clip;
  always_ff @(posedge clk_i) begin
    clip_q.low  <= s1_sum_q[Wide-1];
    clip_q.high <= s1_sum_q[Wide-1:Q] >= (Wide - Q)'(den_q[0]);
  end
  delay #(.T(ends_t), .Stages(Q - 1)) i_clip (.clk_i, .x_i(clip_q), .y_o(clip));

  // Without the 2^(Q-1) again, which turns the highest bit; all ones is then the highest quotient and all zeros the least.
  localparam logic [Q-1:0] Offset = {QSigned, {(Q - 1) {1'b0}}};
  always_ff @(posedge clk_i) begin
    quotient_o <= ((word_q[Q] | {Q{clip.high}}) & ~{Q{clip.low}}) ^ Offset;
    clipped_o  <= clip.low || clip.high;
  end
endmodule
