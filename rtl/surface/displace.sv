// displace: move a point along its normal by the scaled displacement.
//   P' = P + (s D + b) N              contract: hls/surface/displace.hpp
//
//   latency 10, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: every stage
//
//   D --x s--+ b--[s0_height]--x N--+ P--[p]
module displace
  import formats_pkg::*;
  import surface_pkg::*;
(
  input  logic           clk_i,
  input  displace_regs_t regs_i,
  input  displace_in_t   in_i,
  output displace_out_t  out_o
);
  // s0: s D has 40 fractional bits, the height 20.
  logic signed [44:0] s0_product;
  logic signed [45:0] s0_sum_q;
  height_t            s0_height;
  logic               s0_clipped;
  multiply #(.A(24), .B(21)) i_product (
    .clk_i, .a_i(regs_i.scale), .b_i(signed'({1'b0, in_i.d})), .y_o(s0_product)
  );
  always_ff @(posedge clk_i) s0_sum_q <= 46'(s0_product) + 46'(signed'({regs_i.bias, 20'b0}));
  round_to #(.In(46), .Shift(20), .Out(24)) i_height (
    .clk_i, .x_i(s0_sum_q), .y_o(s0_height), .clipped_o(s0_clipped)
  );

  // s1: height N has 34 fractional bits, the position 20.
  logic [2:0] s1_clipped;
  logic       s0_clipped_later;
  delay #(.Stages(5)) i_clipped (.clk_i, .x_i(s0_clipped), .y_o(s0_clipped_later));
  for (genvar i = 0; i < 3; i++) begin : gen_axis
    unit_t              n;
    position_t          p;
    logic signed [39:0] s1_offset;
    logic signed [41:0] s1_sum_q;
    delay #(.T(unit_t), .Stages(5)) i_n (.clk_i, .x_i(in_i.n[i]), .y_o(n));
    delay #(.T(position_t), .Stages(7)) i_p (.clk_i, .x_i(in_i.p[i]), .y_o(p));
    multiply #(.A(24), .B(16)) i_offset (.clk_i, .a_i(s0_height), .b_i(n), .y_o(s1_offset));
    always_ff @(posedge clk_i) s1_sum_q <= 42'(s1_offset) + 42'(signed'({p, 14'b0}));
    round_to #(.In(42), .Shift(14), .Out(24)) i_position (
      .clk_i, .x_i(s1_sum_q), .y_o(out_o.p[i]), .clipped_o(s1_clipped[i])
    );
  end
  assign out_o.saturated = s0_clipped_later | (|s1_clipped);
endmodule
