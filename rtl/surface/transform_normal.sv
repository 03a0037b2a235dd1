// transform_normal: the displaced normal into the eye's frame, and whether it points away from the eye.
//   N'_s = R N';  away = N' . (P' - E) > 0, exact          contract: hls/surface/transform_normal.hpp
//
//   latency 6, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: every stage and the outputs
//   15 multipliers: nine products of 16 x 16 bits, three of 29 x 16
//
//   N' ----------x R--[sum]--[n]
//   P' - E --x N'--[s0_facing]-- > 0 --[away]
module transform_normal
  import formats_pkg::*;
  import surface_pkg::*;
(
  input  logic                   clk_i,
  input  transform_normal_regs_t regs_i,
  input  transform_normal_in_t   in_i,
  output transform_normal_out_t  out_o
);
  // N' a clock later, beside P' - E
  unit_t [2:0] n_q;
  always_ff @(posedge clk_i) n_q <= in_i.n;

  // 28 fractional bits to 14; the host's rotations do not clip, and nobody counts when others do.
  unit_t [2:0] n_s;
  logic  [2:0] unused_clipped;
  for (genvar r = 0; r < 3; r++) begin : gen_row
    logic signed [31:0] product[3];
    logic signed [32:0] sum_q;
    for (genvar i = 0; i < 3; i++) begin : gen_axis
      multiply #(.A(16), .B(16)) i_product (
        .clk_i, .a_i(regs_i.rotation[r][i]), .b_i(n_q[i]), .y_o(product[i])
      );
    end
    always_ff @(posedge clk_i) sum_q <= 33'(product[0]) + 33'(product[1]) + 33'(product[2]);
    round_to #(.In(33), .Shift(14), .Out(16)) i_n (
      .clk_i, .x_i(sum_q), .y_o(n_s[r]), .clipped_o(unused_clipped[r])
    );
  end

  // s0: both differences have 20 fractional bits.
  logic signed [44:0] product[3];
  logic signed [45:0] s0_facing_q;
  for (genvar i = 0; i < 3; i++) begin : gen_facing
    logic signed [28:0] difference_q;
    always_ff @(posedge clk_i) begin
      difference_q <= 29'(signed'(in_i.p[i])) - 29'(signed'(regs_i.eye[i]));
    end
    multiply #(.A(29), .B(16)) i_product (
      .clk_i, .a_i(difference_q), .b_i(n_q[i]), .y_o(product[i])
    );
  end
  logic positive_q, away_q;
  always_ff @(posedge clk_i) begin
    s0_facing_q <= 46'(product[0]) + 46'(product[1]) + 46'(product[2]);
    positive_q <= s0_facing_q > 0;
    away_q <= positive_q;
  end
  assign out_o.n = n_s;
  assign out_o.away = away_q;
endmodule
