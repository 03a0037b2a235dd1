// bump: the normal of the displaced surface from the base frame and the normal map.
//   N' = normalize(N m.z + T m.x + B m.y),  B = N x T          contract: hls/surface/bump.hpp
//
//   latency 31, initiation interval 1; a pure pipeline: never stalls, no reset on data; registered: every stage and the outputs
//   31 multipliers: 15 products of 16 x 16 bits, and the 16 of normalize
//
//   N, T --x--[s0_bitangent]--x m.y--+--[s1_direction]--[normalize]-- n
//        --x m.z, x m.x--------------+
module bump
  import formats_pkg::*;
  import core_pkg::*;
  import surface_pkg::*;
(
  input  logic      clk_i,
  input  bump_in_t  in_i,
  output bump_out_t out_o
);
  unit_t m_y;
  delay #(.T(unit_t), .Stages(5)) i_m_y (.clk_i, .x_i(in_i.m[1]), .y_o(m_y));

  normalize_in_t s1_direction;
  assign s1_direction.tangent = 1'b0;
  logic [2:0] s0_clipped, s1_clipped;
  for (genvar i = 0; i < 3; i++) begin : gen_axis
    // s0: 28 fractional bits to 14.
    localparam int unsigned J = (i + 1) % 3;
    localparam int unsigned K = (i + 2) % 3;
    logic signed [31:0] left, right;
    logic signed [32:0] s0_cross_q;
    unit_t              s0_bitangent;
    multiply #(.A(16), .B(16)) i_left (
      .clk_i, .a_i(in_i.n[J]), .b_i(in_i.t[K]), .y_o(left)
    );
    multiply #(.A(16), .B(16)) i_right (
      .clk_i, .a_i(in_i.n[K]), .b_i(in_i.t[J]), .y_o(right)
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
      .clk_i, .a_i(in_i.n[i]), .b_i(in_i.m[2]), .y_o(along_n)
    );
    multiply #(.A(16), .B(16)) i_along_t (
      .clk_i, .a_i(in_i.t[i]), .b_i(in_i.m[0]), .y_o(along_t)
    );
    always_ff @(posedge clk_i) plane_q <= 33'(along_n) + 33'(along_t);
    delay #(.T(logic [32:0]), .Stages(4)) i_plane (.clk_i, .x_i(plane_q), .y_o(plane));
    multiply #(.A(16), .B(16)) i_along_b (
      .clk_i, .a_i(s0_bitangent), .b_i(m_y), .y_o(along_b)
    );
    always_ff @(posedge clk_i) s1_sum_q <= 33'(signed'(plane)) + 33'(along_b);
    round_to #(.In(33), .Shift(14), .Out(18)) i_direction (
      .clk_i, .x_i(s1_sum_q), .y_o(s1_direction.v[i]), .clipped_o(s1_clipped[i])
    );
  end

  normalize_out_t s2_unit;
  normalize i_normalize (.clk_i, .in_i(s1_direction), .out_o(s2_unit));

  // Clipped: s0 at 5, s1 at 10, the result at 31.
  logic s0_clipped_q, s0_clipped_later, clipped_q;
  always_ff @(posedge clk_i) begin
    s0_clipped_q <= |s0_clipped;
    clipped_q <= s0_clipped_later || (|s1_clipped);
  end
  delay #(.Stages(4)) i_s0_clipped (.clk_i, .x_i(s0_clipped_q), .y_o(s0_clipped_later));
  delay #(.Stages(20)) i_clipped (.clk_i, .x_i(clipped_q), .y_o(out_o.saturated));
  assign out_o.n = s2_unit.n;
  assign out_o.zero = s2_unit.zero;
endmodule
