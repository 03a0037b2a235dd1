// near_clip: a base triangle cut by near, far and the guard band. Entry point of hls/sweep/near_clip.hpp.
//   in     848 bits  vertex 3 x 282: p 3 x 24, n 3 x 16, t 3 x 16, u 2 x 25, colour 4 x 16
//   regs   480 bits  row_x, row_y, row_w 3 x 26 each, offset_x, offset_y, offset_w 52 each, w_min 28, near 28, far 28, guard 1
//   out   2552 bits  vertex 9 x 282, count 4, inside 1, empty 1, overflow 1
//   one word in, one word out a call; as many turns as the unit's header says
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<near_clip_in>::value == 846, "the layout above");
static_assert(field_width<near_clip_regs>::value == 475, "the layout above");
static_assert(field_width<near_clip_out>::value == 2545, "the layout above");

void relievo_near_clip(port<near_clip_in>& in, port_word<near_clip_regs> regs, port<near_clip_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=s_axilite port=return
#endif
  // clang-format on
  out.write(pack(near_clip(unpack<near_clip_in>(in.read()), unpack<near_clip_regs>(regs))));
}
