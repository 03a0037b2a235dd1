// highlight_test: ht of an edge. Entry point of hls/edge/highlight_test.hpp.
//   in       144 bits  n1, n2, n12 3 x 16 each
//   regs      64 bits  half_vector 3 x 16, threshold 16
//   out        8 bits  ht 1
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<highlight_test_in>::value == 144, "the layout above");
static_assert(field_width<highlight_test_regs>::value == 64, "the layout above");
static_assert(field_width<highlight_test_out>::value == 1, "the layout above");

void relievo_highlight_test(port<highlight_test_in>& in, port_word<highlight_test_regs> regs, port<highlight_test_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(highlight_test(unpack<highlight_test_in>(in.read()), unpack<highlight_test_regs>(regs))));
}
