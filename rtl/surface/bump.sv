// bump: the normal of the displaced surface from the base frame and the normal map.
//   N' = normalize(N m.z + T m.x + B m.y),  B = N x T          contract: hls/surface/bump.hpp
//   parameter  Clocks  that a vector takes, 1 or 3: with three its axes take turns up to the normalization
//   in         first_i with three clocks: a vector comes in; the next at the earliest three clocks later
//
//   latency 31, or 34 with three clocks; initiation interval Clocks; a pure pipeline: never stalls, no reset on data; registered: every
//   stage and the outputs
//   31 multipliers: 15 products of 16 x 16 bits, and the 16 of normalize; or 21, with 5 products
//
//   N, T --x--[s0_bitangent]--x m.y--+--[s1_direction]--[normalize]-- n
//        --x m.z, x m.x--------------+
module bump
  import formats_pkg::*;
  import core_pkg::*;
  import surface_pkg::*;
#(
  parameter int unsigned Clocks = 1
) (
  input  logic      clk_i,
  input  logic      first_i,
  input  bump_in_t  in_i,
  output bump_out_t out_o
);
  if (Clocks != 1 && Clocks != 3) begin : gen_bad
    $error("Clocks is 1 or 3");
  end
  localparam int unsigned Axes = Clocks == 1 ? 3 : 1;

  // Axis a of these is axis a, or with three clocks that whose turn it is: the axes walk down by one a clock, and m stands still.
  bump_in_t now;
  if (Clocks == 1) begin : gen_axes
    assign now = in_i;
    logic unused_first;
    assign unused_first = first_i;
  end else begin : gen_axis_by_axis
    bump_in_t now_q;
    always_ff @(posedge clk_i) begin
      now_q.n <= first_i ? in_i.n : {now_q.n[0], now_q.n[2:1]};
      now_q.t <= first_i ? in_i.t : {now_q.t[0], now_q.t[2:1]};
      if (first_i) now_q.m <= in_i.m;
    end
    assign now = now_q;
  end

  unit_t m_y;
  delay #(.T(unit_t), .Stages(5)) i_m_y (.clk_i, .x_i(now.m[1]), .y_o(m_y));

  direction_t [2:0] direction;
  logic [Axes-1:0] s0_clipped, s1_clipped;
  for (genvar i = 0; i < Axes; i++) begin : gen_axis
    // s0: 28 fractional bits to 14.
    localparam int unsigned J = (i + 1) % 3;
    localparam int unsigned K = (i + 2) % 3;
    logic signed [31:0] left, right;
    logic signed [32:0] s0_cross_q;
    unit_t              s0_bitangent;
    multiply #(.A(16), .B(16)) i_left (
      .clk_i, .a_i(now.n[J]), .b_i(now.t[K]), .y_o(left)
    );
    multiply #(.A(16), .B(16)) i_right (
      .clk_i, .a_i(now.n[K]), .b_i(now.t[J]), .y_o(right)
    );
    always_ff @(posedge clk_i) s0_cross_q <= 33'(left) - 33'(right);
    round_to #(.In(33), .Shift(14), .Out(16)) i_bitangent (
      .clk_i, .x_i(s0_cross_q), .y_o(s0_bitangent), .clipped_o(s0_clipped[i])
    );

    // s1: what needs no bitangent is summed at once and waits; 28 fractional bits to 14.
    logic signed [31:0] along_n, along_t, along_b;
    logic signed [32:0] plane_q;
    logic        [32:0] plane;
    logic signed [32:0] s1_sum_q;
    multiply #(.A(16), .B(16)) i_along_n (
      .clk_i, .a_i(now.n[i]), .b_i(now.m[2]), .y_o(along_n)
    );
    multiply #(.A(16), .B(16)) i_along_t (
      .clk_i, .a_i(now.t[i]), .b_i(now.m[0]), .y_o(along_t)
    );
    always_ff @(posedge clk_i) plane_q <= 33'(along_n) + 33'(along_t);
    delay #(.T(logic [32:0]), .Stages(4)) i_plane (.clk_i, .x_i(plane_q), .y_o(plane));
    multiply #(.A(16), .B(16)) i_along_b (
      .clk_i, .a_i(s0_bitangent), .b_i(m_y), .y_o(along_b)
    );
    always_ff @(posedge clk_i) s1_sum_q <= 33'(signed'(plane)) + 33'(along_b);
    round_to #(.In(33), .Shift(14), .Out(18)) i_direction (
      .clk_i, .x_i(s1_sum_q), .y_o(direction[3-Axes+i]), .clipped_o(s1_clipped[i])
    );
  end

  // Clipped: s0 at 5, s1 at 10, and what of the axes before is at its end a clock later.
  logic s0_clipped_q, s0_clipped_later, clipped_q, any_clipped;
  always_ff @(posedge clk_i) begin
    s0_clipped_q <= |s0_clipped;
    clipped_q <= s0_clipped_later || (|s1_clipped);
  end
  delay #(.Stages(4)) i_s0_clipped (.clk_i, .x_i(s0_clipped_q), .y_o(s0_clipped_later));

  if (Clocks == 1) begin : gen_together
    assign any_clipped = clipped_q;
  end else begin : gen_gathered
    logic [1:0] before_q;
    always_ff @(posedge clk_i) before_q <= {clipped_q, before_q[1]};
    delay #(.T(direction_t [1:0])) i_direction (
      .clk_i, .x_i(direction[2:1]), .y_o(direction[1:0])
    );
    assign any_clipped = clipped_q || (|before_q);
  end

  normalize_in_t s1_direction;
  assign s1_direction = '{tangent: 1'b0, v: direction};
  normalize_out_t s2_unit;
  normalize i_normalize (.clk_i, .in_i(s1_direction), .out_o(s2_unit));
  delay #(.Stages(20)) i_clipped (.clk_i, .x_i(any_clipped), .y_o(out_o.saturated));
  assign out_o.n = s2_unit.n;
  assign out_o.zero = s2_unit.zero;
endmodule
