// transform: a world position to the screen: view, perspective and viewport in one matrix and one division.
//   (x, y, w) = M (P', 1);  P'_s = (x/w, y/w)          contract: hls/surface/transform.hpp
//
//   latency 32, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: every stage and the outputs
//   36 multipliers: nine products of 26 x 24 bits
//
//   P' --x row_x + offset--[s0_x]--+
//   P' --x row_y + offset--[s0_y]--+-- / w --[screen]-- (0, 0) where behind
//   P' --x row_w + offset--[w]-----+-- < w_min, = 0 --[behind]
module transform
  import formats_pkg::*;
  import surface_pkg::*;
(
  input  logic            clk_i,
  input  transform_regs_t regs_i,
  input  transform_in_t   in_i,
  output transform_out_t  out_o
);
  localparam int unsigned DivideLatency = 25;

  // The three dot products: 0 is x, 1 is y, 2 is w. Their words have the same widths, and different fractions.
  logic signed [2:0][25:0] row   [3];
  logic signed [51:0]      offset[3];
  logic signed [52:0]      sum_q [3];
  assign row[0] = regs_i.row_x;
  assign row[1] = regs_i.row_y;
  assign row[2] = regs_i.row_w;
  assign offset[0] = regs_i.offset_x;
  assign offset[1] = regs_i.offset_y;
  assign offset[2] = regs_i.offset_w;
  for (genvar r = 0; r < 3; r++) begin : gen_row
    logic signed [49:0] product[3];
    logic signed [50:0] first_q;
    logic signed [52:0] second_q;
    for (genvar i = 0; i < 3; i++) begin : gen_axis
      multiply #(.A(26), .B(24)) i_product (
        .clk_i, .a_i(row[r][i]), .b_i(in_i.p[i]), .y_o(product[i])
      );
    end
    always_ff @(posedge clk_i) begin
      first_q  <= 51'(product[0]) + 51'(product[1]);
      second_q <= 53'(product[2]) + 53'(offset[r]);
      sum_q[r] <= 53'(first_q) + 53'(second_q);
    end
  end

  // s0: the sums of x and y have 34 fractional bits, clip 20.
  clip_t      s0_x, s0_y;
  logic [1:0] s0_clipped;
  round_to #(.In(53), .Shift(14), .Out(38)) i_x (
    .clk_i, .x_i(sum_q[0]), .y_o(s0_x), .clipped_o(s0_clipped[0])
  );
  round_to #(.In(53), .Shift(14), .Out(38)) i_y (
    .clk_i, .x_i(sum_q[1]), .y_o(s0_y), .clipped_o(s0_clipped[1])
  );

  // w: 44 fractional bits to 20. What is negative becomes 0: behind, where nothing counts as clipped. The formats of the
  // registers and the position leave it below 128 + 3 * 16, so the other end is never reached.
  depth_t w;
  logic   unused_w_clipped;
  round_to #(.In(53), .Shift(24), .Out(28), .Signed(1'b0)) i_w (
    .clk_i, .x_i(sum_q[2]), .y_o(w), .clipped_o(unused_w_clipped)
  );

  // behind, beside the first step of the division
  typedef struct packed {
    logic   saturated;
    logic   behind;
    depth_t w;
  } beside_t;
  beside_t beside_q, beside;
  always_ff @(posedge clk_i) begin
    beside_q.saturated <= |s0_clipped;
    beside_q.behind <= w < regs_i.w_min || w == '0;
    beside_q.w <= w;
  end
  delay #(.T(beside_t), .Stages(DivideLatency - 1)) i_beside (
    .clk_i, .x_i(beside_q), .y_o(beside)
  );

  screen_t [1:0] quotient;
  logic    [1:0] clipped;
  divide i_screen_x (
    .clk_i, .num_i(s0_x), .den_i(w), .quotient_o(quotient[0]), .clipped_o(clipped[0])
  );
  divide i_screen_y (
    .clk_i, .num_i(s0_y), .den_i(w), .quotient_o(quotient[1]), .clipped_o(clipped[1])
  );

  always_ff @(posedge clk_i) begin
    out_o.screen <= beside.behind ? '0 : quotient;
    out_o.w <= beside.w;
    out_o.behind <= beside.behind;
    out_o.saturated <= !beside.behind && (beside.saturated || (|clipped));
  end
endmodule
