// transform_cover: both ends of every register of transform that can saturate, and the eye plane from all sides.
//   bound into transform, a pure pipeline: the points also see what lies in it between words
module transform_cover
  import formats_pkg::*;
  import surface_pkg::*;
(
  input logic                  clk_i,
  input transform_regs_t       regs_i,
  input logic            [1:0] s0_clipped,
  input clip_t                 s0_x,
  input clip_t                 s0_y,
  input depth_t                w,
  input logic                  unused_w_clipped,
  input screen_t         [1:0] quotient,
  input logic            [1:0] clipped
);
  logic [1:0] negative;
  assign negative = {quotient[1] < 0, quotient[0] < 0};
  clip_x_top: cover property (@(posedge clk_i) s0_clipped[0] && s0_x > 0);
  clip_y_top: cover property (@(posedge clk_i) s0_clipped[1] && s0_y > 0);
  clip_x_bottom: cover property (@(posedge clk_i) s0_clipped[0] && s0_x < 0);
  clip_y_bottom: cover property (@(posedge clk_i) s0_clipped[1] && s0_y < 0);
  screen_x_top: cover property (@(posedge clk_i) clipped[0] && !negative[0]);
  screen_y_top: cover property (@(posedge clk_i) clipped[1] && !negative[1]);
  screen_x_bottom: cover property (@(posedge clk_i) clipped[0] && negative[0]);
  screen_y_bottom: cover property (@(posedge clk_i) clipped[1] && negative[1]);

  behind_the_eye: cover property (@(posedge clk_i) unused_w_clipped && w == '0);
  in_the_eye_plane: cover property (@(posedge clk_i) !unused_w_clipped && w == '0);
  before_the_nearest: cover property (@(posedge clk_i) w != '0 && w < regs_i.w_min);
  at_the_nearest: cover property (@(posedge clk_i) w != '0 && w == regs_i.w_min);
  beyond_the_nearest: cover property (@(posedge clk_i) w > regs_i.w_min);
endmodule

bind transform transform_cover i_cover (
  .s0_x(s0[0]), .s0_y(s0[Quotients-1]), .*
);
