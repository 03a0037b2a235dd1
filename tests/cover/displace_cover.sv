// displace_cover: both ends of every register of displace that can saturate.
//   bound into displace, a pure pipeline: the points also see what lies in it between words
module displace_cover
  import formats_pkg::*;
  import surface_pkg::*;
(
  input logic          clk_i,
  input logic          s0_clipped,
  input height_t       s0_height,
  input logic [2:0]    s1_clipped,
  input displace_out_t out_o
);
  logic [2:0] negative;
  assign negative = {out_o.p[2] < 0, out_o.p[1] < 0, out_o.p[0] < 0};
  height_top: cover property (@(posedge clk_i) s0_clipped && s0_height > 0);
  height_bottom: cover property (@(posedge clk_i) s0_clipped && s0_height < 0);
  position_x_top: cover property (@(posedge clk_i) s1_clipped[0] && !negative[0]);
  position_y_top: cover property (@(posedge clk_i) s1_clipped[1] && !negative[1]);
  position_z_top: cover property (@(posedge clk_i) s1_clipped[2] && !negative[2]);
  position_x_bottom: cover property (@(posedge clk_i) s1_clipped[0] && negative[0]);
  position_y_bottom: cover property (@(posedge clk_i) s1_clipped[1] && negative[1]);
  position_z_bottom: cover property (@(posedge clk_i) s1_clipped[2] && negative[2]);
endmodule

bind displace displace_cover i_cover (.*);
