// normal_test: does the displaced normal at the new vertex differ from that at either end?
//   nt = any |N'12_i - N'1_i| > threshold or |N'12_i - N'2_i| > threshold
//   contract: hls/edge/normal_test.hpp
//
//   latency 3, initiation interval 1; a pure pipeline: never stalls, no reset on data
//   registered: the six differences, their comparisons, the answer
//
//   N'12 --- N'1,N'2 --[s0_difference]-- > threshold, < -threshold --[s1_over]-- or --[nt]
module normal_test
  import formats_pkg::*;
  import edge_pkg::*;
(
  input  logic              clk_i,
  input  normal_test_regs_t regs_i,
  input  normal_test_in_t   in_i,
  output normal_test_out_t  out_o
);
  // A threshold is 16 bits without a sign, a difference of units 17 with one: both sides in 18.
  logic signed [17:0] threshold;
  assign threshold = signed'({2'b00, regs_i.threshold});

  logic [1:0][2:0] s1_over_q;
  for (genvar i = 0; i < 3; i++) begin : gen_axis
    unit_t n12;
    assign n12 = in_i.n12[i];
    for (genvar k = 0; k < 2; k++) begin : gen_end
      unit_t              n;
      logic signed [17:0] s0_difference_q;
      assign n = k == 0 ? in_i.n1[i] : in_i.n2[i];
      always_ff @(posedge clk_i) s0_difference_q <= 18'(n12) - 18'(n);
      always_ff @(posedge clk_i) begin
        s1_over_q[k][i] <= s0_difference_q > threshold || s0_difference_q < -threshold;
      end
    end
  end
  always_ff @(posedge clk_i) out_o.nt <= |s1_over_q;
endmodule
