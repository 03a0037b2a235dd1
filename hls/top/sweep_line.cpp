// sweep_line: the primitives of a triangle. Entry point of hls/sweep/sweep_line.hpp.
//   in       144 bits  p 3 x 3 x 16                                     one word a call
//   out      216 bits  quad 1, v 4 x (kind 2, number 2, i 16, s 16, t 16), last 1    one word a primitive; `last` with the last one
//   one triangle a call; initiation interval 1 of the primitives
#include "hls/core/streaming_loop.hpp"
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<sweep_line_in>::value == 144, "the layout above");
static_assert(field_width<top::swept_primitive>::value == 210, "the layout above");

void relievo_sweep_line(port<sweep_line_in>& in, port<top::swept_primitive>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=return
#endif
  // clang-format on
  sweep_line walk;
  walk.start(unpack<sweep_line_in>(in.read()));
  top::swept_primitive word;
  do {
#ifndef __BAMBU__
// clang-format off
#pragma HLS PIPELINE II=1
// clang-format on
#endif
    RELIEVO_STREAMING_LOOP("one turn per primitive of the triangle");
    word.last = walk.step(word.p);
    out.write(pack(word));
  } while (!word.last);
}
