// difference_vertices: D_edge, D_sweep and D_side of a triangle. Entry point of hls/sweep/difference_vertices.hpp.
//   in       192 bits  p 3 x 3 x 16, plane 46                                        one word a call
//   corners  448 bits  interpolants: corner 0 to 2, then end 0 and 1 of each edge     nine words a call
//   out     3840 bits  edge 3 x 768, sweep 768, side 768
//   one triangle a call; initiation interval 9, a corner a clock
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<top::placed_triangle>::value == 190, "the layout above");
static_assert(field_width<interpolants>::value == 448, "the layout above");
static_assert(field_width<difference_vertices_out>::value == 3840, "the layout above");

void relievo_difference_vertices(port<top::placed_triangle>& in, port<interpolants>& corners, port<difference_vertices_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=corners
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=9
#endif
  // clang-format on
  out.write(pack(difference_vertices(top::with_corners(unpack<top::placed_triangle>(in.read()), corners))));
}
