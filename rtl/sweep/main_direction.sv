// main_direction: the axis along which an edge is subdivided, and into how many steps.
//   n = max(|dx|, |dy|, |dz|), axis the first that has it                 Gumhold & Huettner 1999, definition 1, Figure 11
//   in    p     grid[2][3], the two ends; exchanging them changes nothing
//   out   axis  0 x, 1 y, 2 z;  n  steps
//   contract: hls/sweep/main_direction.hpp; exact
//
//   latency 4, initiation interval 1; a pure pipeline: never stalls, no reset on data
//   registered: differences, magnitudes, their order, the choice
//
//   p1 - p0 --[s0_difference]-- || --[s1_magnitude]-- order --[s2]-- choose --[out]
module main_direction
  import formats_pkg::*;
  import sweep_pkg::*;
(
  input  logic                clk_i,
  input  main_direction_in_t  in_i,
  output main_direction_out_t out_o
);
  // Two words of 16 bits differ by 65535 at most.
  steps_t [2:0] s1_magnitude_q, s2_magnitude_q;
  for (genvar axis = 0; axis < 3; axis++) begin : gen_axis
    grid_t              from, to;
    logic signed [16:0] s0_difference_q;
    assign from = in_i.p[0][axis];
    assign to = in_i.p[1][axis];
    always_ff @(posedge clk_i) begin
      s0_difference_q <= 17'(to) - 17'(from);
      s1_magnitude_q[axis] <= s0_difference_q[16] ? 16'(-s0_difference_q) : 16'(s0_difference_q);
    end
  end

  logic s2_y_above_x_q, s2_z_above_x_q, s2_z_above_y_q;
  always_ff @(posedge clk_i) begin
    s2_y_above_x_q <= s1_magnitude_q[1] > s1_magnitude_q[0];
    s2_z_above_x_q <= s1_magnitude_q[2] > s1_magnitude_q[0];
    s2_z_above_y_q <= s1_magnitude_q[2] > s1_magnitude_q[1];
    s2_magnitude_q <= s1_magnitude_q;
  end

  logic z;
  assign z = s2_y_above_x_q ? s2_z_above_y_q : s2_z_above_x_q;
  always_ff @(posedge clk_i) begin
    out_o.axis <= z ? 2'd2 : s2_y_above_x_q ? 2'd1 : 2'd0;
    out_o.n <= z ? s2_magnitude_q[2] : s2_y_above_x_q ? s2_magnitude_q[1] : s2_magnitude_q[0];
  end
endmodule
