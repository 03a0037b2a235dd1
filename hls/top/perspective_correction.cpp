// perspective_correction: a vertex in the world again. Entry point of hls/sweep/perspective_correction.hpp.
//   in       768 bits  v: p, n, t 3 x 48 each, u 2 x 48, colour 4 x 48, c 48
//   regs      56 bits  limit 2 x 25
//   out      320 bits  p 3 x 24, n 3 x 16, t 3 x 16, u 2 x 25, colour 4 x 16, w_correction 26, shift 6, saturated 1
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<perspective_correction_in>::value == 768, "the layout above");
static_assert(field_width<perspective_correction_regs>::value == 50, "the layout above");
static_assert(field_width<perspective_correction_out>::value == 315, "the layout above");

void relievo_perspective_correction(port<perspective_correction_in>& in, port_word<perspective_correction_regs> regs,
                                    port<perspective_correction_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(perspective_correction(unpack<perspective_correction_in>(in.read()), unpack<perspective_correction_regs>(regs))));
}
