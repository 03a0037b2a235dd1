// sweep_vertices: the primitives of a triangle with the data of their vertices. Entry point of hls/sweep/sweep_line.hpp.
//   in       144 bits  p 3 x 3 x 16                                                  one word a call
//   corners  448 bits  interpolants: corner 0 to 2, then end 0 and 1 of each edge     nine words a call
//   out     3288 bits  p 209: as sweep_line, data 4 x 768, last 1                    one word a primitive; `last` with the last one
//   one triangle a call; initiation interval 1 of the primitives
#include "hls/core/streaming_loop.hpp"
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<sweep_line_in>::value == 144, "the layout above");
static_assert(field_width<interpolants>::value == 448, "the layout above");
static_assert(field_width<top::swept_vertices>::value == 3282, "the layout above");

void relievo_sweep_vertices(port<sweep_line_in>& in, port<interpolants>& corners, port<top::swept_vertices>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=corners
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=return
#endif
  // clang-format on
  const auto triangle = unpack<sweep_line_in>(in.read());
  const sweep_setup setup = set_up(triangle);
  top::placed_triangle placed;
  placed.plane = setup.plane;
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) placed.p[i][axis] = triangle.p[i][axis];
  const difference_vertices_in data = top::with_corners(placed, corners);
  sweep_line_of<vertex_steps> walk;
  walk.start(triangle, setup, walk_data_of(data, difference_vertices(data)));
  top::swept_vertices word;
  do {
#ifndef __BAMBU__
// clang-format off
#pragma HLS PIPELINE II=1
// clang-format on
#endif
    RELIEVO_STREAMING_LOOP("one turn per primitive of the triangle");
    word.last = walk.step(word.p, word.data);
    out.write(pack(word));
  } while (!word.last);
}
