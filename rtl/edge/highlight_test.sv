// highlight_test: does an end or the new vertex lie in a Phong highlight?
//   ht = any N' . H > threshold       contract: hls/edge/highlight_test.hpp
//
//   latency 4, initiation interval 1; a pure pipeline: never stalls, no reset on data
//   registered: nine products, three sums, three comparisons, whose bare OR is the answer
//
//   N'1, N'2, N'12 --x H--[s0_product]-- + + --[s1_dot]-- > threshold --[s2_over]-- or -- ht
module highlight_test
  import formats_pkg::*;
  import edge_pkg::*;
(
  input  logic                 clk_i,
  input  highlight_test_regs_t regs_i,
  input  highlight_test_in_t   in_i,
  output highlight_test_out_t  out_o
);
  unit_t [2:0][2:0] n;
  assign n = {in_i.n12, in_i.n2, in_i.n1};

  logic [2:0] s2_over_q;
  for (genvar k = 0; k < 3; k++) begin : gen_normal
    // A product has 28 fractional bits and 32 in all; three of them fit 34.
    logic signed [2:0][31:0] s0_product;
    logic signed [33:0]      s1_dot_q;
    for (genvar i = 0; i < 3; i++) begin : gen_axis
      multiply #(.A(16), .B(16)) i_product (
        .clk_i, .a_i(n[k][i]), .b_i(regs_i.half_vector[i]), .y_o(s0_product[i])
      );
    end
    always_ff @(posedge clk_i) begin
      s1_dot_q <= 34'(signed'(s0_product[0])) + 34'(signed'(s0_product[1]))
                + 34'(signed'(s0_product[2]));
      s2_over_q[k] <= s1_dot_q > 34'(signed'({regs_i.threshold, 14'b0}));
    end
  end
  assign out_o.ht = |s2_over_q;
endmodule
