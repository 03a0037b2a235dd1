// base_triangle_clip: is all of a displaced triangle out of sight? Entry point of hls/sweep/base_triangle_clip.hpp.
//   in    240 bits  screen 3 x 2 x 22, w 3 x 28, d_max 24
//   regs  184 bits  viewport 2 x 22, reach 2 x 26, near 28, far 28, d_scale 26
//   out     8 bits  rejected 1
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<base_triangle_clip_in>::value == 240, "the layout above");
static_assert(field_width<base_triangle_clip_regs>::value == 178, "the layout above");
static_assert(field_width<base_triangle_clip_out>::value == 1, "the layout above");

void relievo_base_triangle_clip(port<base_triangle_clip_in>& in, port_word<base_triangle_clip_regs> regs,
                                port<base_triangle_clip_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(base_triangle_clip(unpack<base_triangle_clip_in>(in.read()), unpack<base_triangle_clip_regs>(regs))));
}
