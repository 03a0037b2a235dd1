// normal_map_cover: the builder at each border of the map, clamped and wrapped, maps of one row and of one column, slopes beyond the
// format, and both sides of it waiting.
//   bound into normal_map; slopes are a pure pipeline's: those points also see what lies in it between words
module normal_map_cover
  import core_pkg::*;
  import surface_pkg::*;
(
  input logic                clk_i,
  input logic                rst_ni,
  input map_regs_t           map_i,
  input logic                step,
  input logic                yields,
  input logic                first_column,
  input logic                last_column,
  input logic                row_is_1_q,
  input logic          [1:0] phase_i,
  input logic          [1:0] s1_clipped,
  input normalize_in_t       s1_direction,
  input logic                in_valid_i,
  input logic                in_ready_o,
  input logic                pipe_ready,
  input logic                out_valid_o,
  input logic                out_ready_i
);
  // A step yields the texel below and left of it; rows: Reading 0, LastRow 1, RowZero 2.
  logic moves;
  assign moves = rst_ni && step && yields;
  clamped_left: cover property (@(posedge clk_i) moves && first_column && !map_i.wrap_u);
  clamped_right: cover property (@(posedge clk_i) moves && last_column && !map_i.wrap_u);
  clamped_bottom: cover property (@(posedge clk_i) moves && row_is_1_q && !map_i.wrap_v);
  clamped_top: cover property (@(posedge clk_i) moves && phase_i == 2'd1 && !map_i.wrap_v);
  wrapped_left: cover property (@(posedge clk_i) moves && first_column && map_i.wrap_u);
  wrapped_right: cover property (@(posedge clk_i) moves && last_column && map_i.wrap_u);
  wrapped_top: cover property (@(posedge clk_i) moves && phase_i == 2'd1 && map_i.wrap_v);
  wrapped_bottom: cover property (@(posedge clk_i) moves && phase_i == 2'd2 && map_i.wrap_v);
  one_column: cover property (@(posedge clk_i) moves && map_i.width == 14'd1);
  one_row_clamped: cover property (@(posedge clk_i) moves && map_i.height == 14'd1
                                                    && !map_i.wrap_v);
  one_row_wrapped: cover property (@(posedge clk_i) moves && map_i.height == 14'd1 && map_i.wrap_v);

  slope_u_top: cover property (@(posedge clk_i) s1_clipped[0] && s1_direction.v[0] > 0);
  slope_v_top: cover property (@(posedge clk_i) s1_clipped[1] && s1_direction.v[1] > 0);
  slope_u_bottom: cover property (@(posedge clk_i) s1_clipped[0] && s1_direction.v[0] < 0);
  slope_v_bottom: cover property (@(posedge clk_i) s1_clipped[1] && s1_direction.v[1] < 0);

  in_waits: cover property (@(posedge clk_i) rst_ni && in_valid_i && !in_ready_o);
  pipe_full: cover property (@(posedge clk_i) rst_ni && yields && !pipe_ready);
  out_waits: cover property (@(posedge clk_i) rst_ni && out_valid_o && !out_ready_i);
endmodule

bind normal_map normal_map_cover i_cover (
  .phase_i(phase_q),
  .*
);
