// bilinear: the sum of a quad of words by two fractions of 11 bits, exact, then rounded once.
//   y = round(q00 (1-fx)(1-fy) + q01 fx (1-fy) + q10 (1-fx) fy + q11 fx fy)
//   contract: bilinear of hls/surface/map_address.hpp, then round_to
//   parameters  Width of a word, Signed, Kept: fractional bits that the result has more than the words
//   in    q_i   [row][column];  f_i  fractions of u and v
//   out   y_o   Width + Kept bits; a mean of the words never clips
//
//   latency 10, initiation interval 1; a pure pipeline; registered: every stage; 4 multipliers of 18 x 18 for words of 16 bits, where both
//   weights of each pair would take 8
//
//   With F = 2^11 fx, an integer: q0 (2^11 - F) + q1 F = 2^11 q0 + F (q1 - q0), term by term, and nothing is rounded before the end:
//   the words are those of the contract's two products. The same between the rows r0, r1: 2^11 r0 + 2^11 fy (r1 - r0).
//   A row lies between its words, so that a difference needs one bit more than what it is taken of.
//
//   q --[s0_step: q1 - q0]--x fx--+ q0--[s1_row]--[s2_step: r1 - r0]--x fy--+ r0--[s3_sum]--[y]
module bilinear
  import formats_pkg::*;
#(
  parameter int unsigned Width = 16,
  parameter bit Signed = 1'b0,
  parameter int unsigned Kept = 4
) (
  input  logic                            clk_i,
  input  logic      [1:0][1:0][Width-1:0] q_i,
  input  fraction_t [1:0]                 f_i,
  output logic      [Width+Kept-1:0]      y_o
);
  localparam int unsigned Fraction = FractionFraction;

  logic signed [Fraction:0] s0_fx_q, s2_fy;
  always_ff @(posedge clk_i) s0_fx_q <= signed'({1'b0, f_i[0]});
  fraction_t fy;
  delay #(.T(fraction_t), .Stages(5)) i_fy (.clk_i, .x_i(f_i[1]), .y_o(fy));
  assign s2_fy = signed'({1'b0, fy});

  // s1: the rows have 11 fractional bits more than the words.
  logic signed [Width+Fraction:0] s1_row_q [2];
  for (genvar row = 0; row < 2; row++) begin : gen_row
    logic signed [Width:0] left, right, s0_step_q, s1_left;
    logic signed [Width+Fraction+1:0] s1_product;
    assign left = signed'({Signed && q_i[row][0][Width-1], q_i[row][0]});
    assign right = signed'({Signed && q_i[row][1][Width-1], q_i[row][1]});
    always_ff @(posedge clk_i) s0_step_q <= right - left;
    multiply #(.A(Width + 1), .B(Fraction + 1)) i_product (
      .clk_i, .a_i(s0_step_q), .b_i(s0_fx_q), .y_o(s1_product)
    );
    delay #(.T(logic [Width:0]), .Stages(3)) i_left (.clk_i, .x_i(left), .y_o(s1_left));
    always_ff @(posedge clk_i) begin
      s1_row_q[row] <= signed'({s1_left, {Fraction{1'b0}}}) + s1_product[Width+Fraction:0];
    end
    logic unused_sign;
    assign unused_sign = s1_product[Width+Fraction+1];
  end

  // s3: the sum has 22.
  logic signed [Width+Fraction:0] s2_step_q, s3_row;
  logic signed [Width+2*Fraction+1:0] s3_product;
  logic signed [Width+2*Fraction:0] s3_sum_q;
  always_ff @(posedge clk_i) s2_step_q <= s1_row_q[1] - s1_row_q[0];
  multiply #(.A(Width + Fraction + 1), .B(Fraction + 1)) i_product (
    .clk_i, .a_i(s2_step_q), .b_i(s2_fy), .y_o(s3_product)
  );
  delay #(.T(logic [Width+Fraction:0]), .Stages(3)) i_row (
    .clk_i, .x_i(s1_row_q[0]), .y_o(s3_row)
  );
  always_ff @(posedge clk_i) begin
    s3_sum_q <= signed'({s3_row, {Fraction{1'b0}}}) + s3_product[Width+2*Fraction:0];
  end
  logic unused_sign;
  assign unused_sign = s3_product[Width+2*Fraction+1];

  logic unused_clipped;
  round_to #(
    .In(Width + 2 * Fraction + 1), .Shift(2 * Fraction - Kept), .Out(Width + Kept), .Signed(Signed)
  ) i_round (
    .clk_i, .x_i(s3_sum_q), .y_o, .clipped_o(unused_clipped)
  );
endmodule
