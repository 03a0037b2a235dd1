// bump_cover: both ends of every register of bump that can saturate, and the vector that vanishes.
//   bound into bump, a pure pipeline: the points also see what lies in it between words
module bump_cover
  import core_pkg::*;
  import surface_pkg::*;
(
  input logic          clk_i,
  input logic    [2:0] s0_clipped,
  input logic    [2:0] s0_negative_i,
  input logic    [2:0] s1_clipped,
  input normalize_in_t s1_direction,
  input bump_out_t     out_o
);
  logic [2:0] s1_negative;
  assign s1_negative = {s1_direction.v[2] < 0, s1_direction.v[1] < 0, s1_direction.v[0] < 0};
  bitangent_x_top: cover property (@(posedge clk_i) s0_clipped[0] && !s0_negative_i[0]);
  bitangent_y_top: cover property (@(posedge clk_i) s0_clipped[1] && !s0_negative_i[1]);
  bitangent_z_top: cover property (@(posedge clk_i) s0_clipped[2] && !s0_negative_i[2]);
  bitangent_x_bottom: cover property (@(posedge clk_i) s0_clipped[0] && s0_negative_i[0]);
  bitangent_y_bottom: cover property (@(posedge clk_i) s0_clipped[1] && s0_negative_i[1]);
  bitangent_z_bottom: cover property (@(posedge clk_i) s0_clipped[2] && s0_negative_i[2]);
  direction_x_top: cover property (@(posedge clk_i) s1_clipped[0] && !s1_negative[0]);
  direction_y_top: cover property (@(posedge clk_i) s1_clipped[1] && !s1_negative[1]);
  direction_z_top: cover property (@(posedge clk_i) s1_clipped[2] && !s1_negative[2]);
  direction_x_bottom: cover property (@(posedge clk_i) s1_clipped[0] && s1_negative[0]);
  direction_y_bottom: cover property (@(posedge clk_i) s1_clipped[1] && s1_negative[1]);
  direction_z_bottom: cover property (@(posedge clk_i) s1_clipped[2] && s1_negative[2]);
  normal_vanishes: cover property (@(posedge clk_i) out_o.zero);
endmodule

bind bump bump_cover i_cover (
  .s0_clipped(3'(s0_clipped)),
  .s1_clipped(3'(s1_clipped)),
  .s0_negative_i({
    gen_axis[Axes-1].s0_bitangent < 0, gen_axis[Axes/2].s0_bitangent < 0, gen_axis[0].s0_bitangent < 0
  }),
  .*
);
