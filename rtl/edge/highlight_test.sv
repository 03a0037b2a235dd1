// highlight_test: does an end or the new vertex lie in a Phong highlight?
//   ht = any N' . H > threshold       contract: hls/edge/highlight_test.hpp
//   parameter  Clocks  that an edge takes, 1 or 3: with three its normals take turns
//   in         first_i with three clocks: an edge comes in; the next at the earliest three clocks later
//
//   latency 4, or 7 with three clocks; initiation interval Clocks; a pure pipeline: never stalls, no reset on data; 9 multipliers, or 3
//   registered: the products, their sums, the comparisons, whose bare OR is the answer
//
//   N'1, N'2, N'12 --x H--[s0_product]-- + + --[s1_dot]-- > threshold --[s2_over]-- or -- ht
module highlight_test
  import formats_pkg::*;
  import edge_pkg::*;
#(
  parameter int unsigned Clocks = 1
) (
  input  logic                 clk_i,
  input  logic                 first_i,
  input  highlight_test_regs_t regs_i,
  input  highlight_test_in_t   in_i,
  output highlight_test_out_t  out_o
);
  if (Clocks != 1 && Clocks != 3) begin : gen_bad
    $error("Clocks is 1 or 3");
  end
  localparam int unsigned Normals = Clocks == 1 ? 3 : 1;
  unit_t [Normals-1:0][2:0] n;
  logic  [2:0]              s2_over_q;
  if (Clocks == 1) begin : gen_normals
    assign n = {in_i.n12, in_i.n2, in_i.n1};
    logic unused_first;
    assign unused_first = first_i;
  end else begin : gen_one_by_one
    unit_t [2:0][2:0] n_q;
    always_ff @(posedge clk_i) begin
      n_q <= first_i ? {in_i.n12, in_i.n2, in_i.n1} : {n_q[0], n_q[2:1]};
      s2_over_q[2:1] <= s2_over_q[1:0];
    end
    assign n[0] = n_q[0];
  end

  for (genvar k = 0; k < Normals; k++) begin : gen_normal
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
