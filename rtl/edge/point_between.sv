// point_between: what lies at k/16 between two words, rounded half up once.
//   y = floor((a (16 - k) + b k) / 2^Drop + 1/2)          weighted_sum of hls/edge/calculate_new_p.hpp, and its rounding
//   in    a_i, b_i  Width bits, signed if Signed;  k_i  0..16 (more is no weight, and gives no sum)
//   out   y_o       Width + 4 - Drop bits; Drop = 4 gives the point, 3 twice the point with a bit more
//
//   latency 4, initiation interval 1; registered: b - a, its parts, their sum, and the output; no multiplier
//
//   The sum is 16 a + (b - a) k; the half stands below 16 a, where there is room. Nothing clips: the point lies between the ends.
module point_between #(
  parameter int unsigned Width = 24,
  parameter bit Signed = 1'b1,
  parameter int unsigned Drop = 4
) (
  input  logic                  clk_i,
  input  logic [Width-1:0]      a_i,
  input  logic [Width-1:0]      b_i,
  input  logic [4:0]            k_i,
  output logic [Width+3-Drop:0] y_o
);
  // 16 times what lies between fits, so the parts may be modulo 2^Sum.
  localparam int unsigned Sum = Width + 4;

  logic signed [Width:0]   difference_q;
  logic        [4:0]       k_q;
  logic signed [Width+2:0] low_q;   // b - a times 0..3
  logic signed [Width+1:0] high_q;  // b - a times 0..4, the weight's quarters
  logic        [Sum-1:0]   parts_q;
  logic        [Width-1:0] a;
  always_ff @(posedge clk_i) begin
    difference_q <= signed'({Signed & b_i[Width-1], b_i}) - signed'({Signed & a_i[Width-1], a_i});
    k_q <= k_i;
    low_q <= (k_q[0] ? (Width + 3)'(difference_q) : '0)
           + (k_q[1] ? (Width + 3)'(difference_q) <<< 1 : '0);
    high_q <= (k_q[2] ? (Width + 2)'(difference_q) : '0)
            + (k_q[3] ? (Width + 2)'(difference_q) <<< 1 : '0)
            + (k_q[4] ? (Width + 2)'(difference_q) <<< 2 : '0);
    parts_q <= Sum'(low_q) + {high_q, 2'b0};
  end
  delay #(.T(logic [Width-1:0]), .Stages(3)) i_a (.clk_i, .x_i(a_i), .y_o(a));

  logic [Sum-1:0] sum;
  assign sum = {a, 4'(1 << (Drop - 1))} + parts_q;
  always_ff @(posedge clk_i) y_o <= sum[Sum-1:Drop];
  logic unused_sum;
  assign unused_sum = ^sum[Drop-1:0];
endmodule
