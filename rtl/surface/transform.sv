// transform: a world position to the screen: view, perspective and viewport in one matrix and one division.
//   (x, y, w) = M (P', 1);  P'_s = (x/w, y/w)          contract: hls/surface/transform.hpp
//   parameter  Clocks  that a position takes, 1 or 3: with three the rows w, x, y take turns on one dot product and one divider
//   in         first_i with three clocks: a position comes in; the next at the earliest three clocks later
//
//   latency 32, or 35 with three clocks; initiation interval Clocks; a pure pipeline: never stalls, no reset on data; registered: every
//   stage and the outputs
//   36 multipliers, nine products of 26 x 24 bits, or 12, three of them
//
//   P' --x row_w + offset--[w]-----+-- < w_min, = 0 --[behind]
//   P' --x row_x + offset--[s0_x]--+
//   P' --x row_y + offset--[s0_y]--+-- / w --[screen]-- (0, 0) where behind
module transform
  import formats_pkg::*;
  import surface_pkg::*;
#(
  parameter int unsigned Clocks = 1
) (
  input  logic            clk_i,
  input  logic            first_i,
  input  transform_regs_t regs_i,
  input  transform_in_t   in_i,
  output transform_out_t  out_o
);
  localparam int unsigned DivideLatency = 25;
  if (Clocks != 1 && Clocks != 3) begin : gen_bad
    $error("Clocks is 1 or 3");
  end

  // The dot products: 0 is w, 1 is x, 2 is y. Their words have the same widths, and different fractions.
  localparam int unsigned Rows = Clocks == 1 ? 3 : 1;
  typedef struct packed {
    logic signed [51:0]      offset;
    logic signed [2:0][25:0] m;
  } row_t;
  row_t            matrix[3];
  row_t            row   [Rows];
  position_t [2:0] p;
  assign matrix[0] = {regs_i.offset_w, regs_i.row_w};
  assign matrix[1] = {regs_i.offset_x, regs_i.row_x};
  assign matrix[2] = {regs_i.offset_y, regs_i.row_y};
  if (Clocks == 1) begin : gen_rows
    assign row = matrix;
    assign p = in_i.p;
    logic unused_first;
    assign unused_first = first_i;
  end else begin : gen_row_by_row
    // The position stands still beside its three rows. A row is of use from two clocks later on, when its offset is added.
    row_t            row_q;
    position_t [2:0] p_q;
    logic            second_q;
    always_ff @(posedge clk_i) begin
      second_q <= first_i;
      row_q <= first_i ? matrix[0] : second_q ? matrix[1] : matrix[2];
      if (first_i) p_q <= in_i.p;
    end
    delay #(.T(logic [51:0]), .Stages(2)) i_offset (
      .clk_i, .x_i(row_q.offset), .y_o(row[0].offset)
    );
    assign row[0].m = row_q.m;
    assign p = p_q;
  end

  logic signed [52:0] sum_q[Rows];
  for (genvar r = 0; r < Rows; r++) begin : gen_row
    logic signed [49:0] product[3];
    logic signed [50:0] first_q;
    logic signed [52:0] second_q;
    for (genvar i = 0; i < 3; i++) begin : gen_axis
      multiply #(.A(26), .B(24)) i_product (
        .clk_i, .a_i(row[r].m[i]), .b_i(p[i]), .y_o(product[i])
      );
    end
    always_ff @(posedge clk_i) begin
      first_q  <= 51'(product[0]) + 51'(product[1]);
      second_q <= 53'(product[2]) + 53'(row[r].offset);
      sum_q[r] <= 53'(first_q) + 53'(second_q);
    end
  end

  // s0: the sums of x and y have 34 fractional bits, clip 20.
  localparam int unsigned Quotients = Clocks == 1 ? 2 : 1;
  clip_t      s0[Quotients];
  logic [1:0] s0_clipped;
  for (genvar i = 0; i < Quotients; i++) begin : gen_clip
    round_to #(.In(53), .Shift(14), .Out(38)) i_clip (
      .clk_i, .x_i(sum_q[Rows==1?0:1+i]), .y_o(s0[i]), .clipped_o(s0_clipped[i])
    );
  end

  // w: 44 fractional bits to 20. What is negative becomes 0: behind, where nothing counts as clipped. The formats of the
  // registers and the position leave it below 128 + 3 * 16, so the other end is never reached.
  depth_t w, divisor;
  logic   unused_w_clipped;
  round_to #(.In(53), .Shift(24), .Out(28), .Signed(1'b0)) i_w (
    .clk_i, .x_i(sum_q[0]), .y_o(w), .clipped_o(unused_w_clipped)
  );

  // Quotients, and what is clipped in either: beside each other at the second one.
  screen_t [1:0] quotient;
  logic    [1:0] clipped;
  if (Clocks == 1) begin : gen_divisor
    assign divisor = w;
  end else begin : gen_held_divisor
    // w is there seven clocks after its position, a clock before x.
    logic   w_now;
    depth_t w_q;
    delay #(.Stages(7)) i_w_now (.clk_i, .x_i(first_i), .y_o(w_now));
    always_ff @(posedge clk_i) if (w_now) w_q <= w;
    assign divisor = w_q;
    delay i_s0_clipped (.clk_i, .x_i(s0_clipped[0]), .y_o(s0_clipped[1]));
    delay #(.T(screen_t)) i_quotient (.clk_i, .x_i(quotient[1]), .y_o(quotient[0]));
    delay i_clipped (.clk_i, .x_i(clipped[1]), .y_o(clipped[0]));
  end
  for (genvar i = 0; i < Quotients; i++) begin : gen_quotient
    localparam int unsigned Axis = Clocks == 1 ? i : 1;
    divide i_screen (
      .clk_i,
      .num_i(s0[i]),
      .den_i(divisor),
      .quotient_o(quotient[Axis]),
      .clipped_o(clipped[Axis])
    );
  end

  // behind, beside the first step of the division
  typedef struct packed {
    logic   saturated;
    logic   behind;
    depth_t w;
  } beside_t;
  beside_t beside_q, beside;
  always_ff @(posedge clk_i) begin
    beside_q.saturated <= |s0_clipped;
    beside_q.behind <= divisor < regs_i.w_min || divisor == '0;
    beside_q.w <= divisor;
  end
  delay #(.T(beside_t), .Stages(DivideLatency - 1)) i_beside (
    .clk_i, .x_i(beside_q), .y_o(beside)
  );

  always_ff @(posedge clk_i) begin
    out_o.screen <= beside.behind ? '0 : quotient;
    out_o.w <= beside.w;
    out_o.behind <= beside.behind;
    out_o.saturated <= !beside.behind && (beside.saturated || (|clipped));
  end
endmodule
