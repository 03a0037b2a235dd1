// profile_levels: into how many intervals the profile of an edge is divided, and the edge's extent.
//   d = larger extent in texels; levels = log2 of the smallest power of two >= d, 1 at least, log2 ProfileIntervalsMax at most; 0 where
//   d < 1.5
//   contract: detail::profile_levels of hls/edge/profile_test.hpp
//   in    u1_i, u2_i
//   out   levels_o;  extent_o  u2 - u1
//
//   latency 3, initiation interval 1; a pure pipeline: never stalls, no reset on data
//   registered: the two differences, their magnitudes, the levels
module profile_levels
  import formats_pkg::*;
(
  input  logic                    clk_i,
  input  coordinate_t [1:0]       u1_i,
  input  coordinate_t [1:0]       u2_i,
  output logic        [2:0]       levels_o,
  output logic signed [1:0][25:0] extent_o
);
  localparam int unsigned LevelsMax = $clog2(ProfileIntervalsMax);

  logic signed [25:0] s0_difference_q [2];
  logic        [24:0] s1_extent_q [2];
  logic        [25:0] negated [2];
  for (genvar i = 0; i < 2; i++) begin : gen_axis
    assign negated[i] = 26'(-s0_difference_q[i]);
    always_ff @(posedge clk_i) begin
      s0_difference_q[i] <= signed'({1'b0, u2_i[i]}) - signed'({1'b0, u1_i[i]});
      s1_extent_q[i] <= s0_difference_q[i][25] ? negated[i][24:0] : s0_difference_q[i][24:0];
    end
    logic unused_sign;
    assign unused_sign = negated[i][25];
    delay #(.T(logic [25:0]), .Stages(2)) i_extent (
      .clk_i, .x_i(s0_difference_q[i]), .y_o(extent_o[i])
    );
  end

  // What holds of the larger extent holds of either.
  function automatic logic beyond(logic [24:0] u, logic [24:0] v, int unsigned texels_doubled);
    return u > 25'(texels_doubled << (CoordinateFraction - 1))
        || v > 25'(texels_doubled << (CoordinateFraction - 1));
  endfunction
  logic [2:0] s2_levels;
  always_comb begin
    s2_levels = 3'd1;
    for (int unsigned l = 1; l < LevelsMax; l++) begin
      if (beyond(s1_extent_q[0], s1_extent_q[1], 2 << l)) s2_levels = 3'(l + 1);
    end
    if (s1_extent_q[0] < 25'(3 << (CoordinateFraction - 1))
        && s1_extent_q[1] < 25'(3 << (CoordinateFraction - 1))) begin
      s2_levels = '0;
    end
  end
  always_ff @(posedge clk_i) levels_o <= s2_levels;
endmodule
