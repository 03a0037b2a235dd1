// view_test: is the edge longer on the screen than the user asks for?
//   vt = |x1 - x2| + |y1 - y2| > threshold, or an end is at or behind the eye
//   contract: hls/edge/view_test.hpp
//
//   latency 4, initiation interval 1; a pure pipeline: never stalls, no reset on data
//   registered: differences, magnitudes, their sum, the answer
//
//   P'_s1 - P'_s2 --[s0_difference]-- || --[s0_magnitude]-- + --[s0_distance]-- > threshold --[vt]
module view_test
  import formats_pkg::*;
  import edge_pkg::*;
(
  input  logic            clk_i,
  input  view_test_regs_t regs_i,
  input  view_test_in_t   in_i,
  output view_test_out_t  out_o
);
  // A difference of two screen words of 22 bits has a magnitude below 2^22; the sum of two is below 2^23.
  logic [1:0][21:0] s0_magnitude_q;
  for (genvar i = 0; i < 2; i++) begin : gen_axis
    screen_t            first, second;
    logic signed [22:0] s0_difference_q;
    assign first = in_i.screen1[i];
    assign second = in_i.screen2[i];
    always_ff @(posedge clk_i) begin
      s0_difference_q <= 23'(first) - 23'(second);
      s0_magnitude_q[i] <= s0_difference_q[22] ? 22'(-s0_difference_q) : 22'(s0_difference_q);
    end
  end

  logic [23:0] s0_distance_q;
  always_ff @(posedge clk_i) s0_distance_q <= 24'(s0_magnitude_q[0]) + 24'(s0_magnitude_q[1]);

  logic behind;
  delay #(.Stages(3)) i_behind (.clk_i, .x_i(in_i.behind1 || in_i.behind2), .y_o(behind));
  always_ff @(posedge clk_i) out_o.vt <= behind || s0_distance_q > regs_i.threshold;
endmodule
