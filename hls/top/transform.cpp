// transform: P' to the screen. Entry point of hls/surface/transform.hpp.
//   in        72 bits  p 3 x 24
//   regs     424 bits  row_x, row_y, row_w 3 x 26 each, offset_x, offset_y, offset_w 52 each, w_min 28
//   out       80 bits  screen 2 x 22, w 28, behind 1, saturated 1
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<transform_in>::value == 72, "the layout above");
static_assert(field_width<transform_regs>::value == 418, "the layout above");
static_assert(field_width<transform_out>::value == 74, "the layout above");

void relievo_transform(port<transform_in>& in, port_word<transform_regs> regs, port<transform_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(transform(unpack<transform_in>(in.read()), unpack<transform_regs>(regs))));
}
