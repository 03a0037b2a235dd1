// transform_normal: N' into the eye's frame. Entry point of hls/surface/transform_normal.hpp.
//   in       120 bits  p 3 x 24, n 3 x 16
//   regs     232 bits  rotation 9 x 16, eye 3 x 28
//   out       56 bits  n 3 x 16, away 1
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<transform_normal_in>::value == 120, "the layout above");
static_assert(field_width<transform_normal_regs>::value == 228, "the layout above");
static_assert(field_width<transform_normal_out>::value == 49, "the layout above");

void relievo_transform_normal(port<transform_normal_in>& in, port_word<transform_normal_regs> regs, port<transform_normal_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(transform_normal(unpack<transform_normal_in>(in.read()), unpack<transform_normal_regs>(regs))));
}
