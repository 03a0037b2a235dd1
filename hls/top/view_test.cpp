// view_test: vt of an edge. Entry point of hls/edge/view_test.hpp.
//   in        96 bits  screen1, screen2 2 x 22 each, behind1 1, behind2 1
//   regs      24 bits  threshold 24
//   out        8 bits  vt 1
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<view_test_in>::value == 90, "the layout above");
static_assert(field_width<view_test_regs>::value == 24, "the layout above");
static_assert(field_width<view_test_out>::value == 1, "the layout above");

void relievo_view_test(port<view_test_in>& in, port_word<view_test_regs> regs, port<view_test_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(view_test(unpack<view_test_in>(in.read()), unpack<view_test_regs>(regs))));
}
