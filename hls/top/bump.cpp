// bump: N' from N, T and the normal of the map. Entry point of hls/surface/bump.hpp.
//   in       144 bits  n, t, m 3 x 16 each
//   out       56 bits  n 3 x 16, saturated 1, zero 1
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<bump_in>::value == 144, "the layout above");
static_assert(field_width<bump_out>::value == 50, "the layout above");

void relievo_bump(port<bump_in>& in, port<bump_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(bump(unpack<bump_in>(in.read()))));
}
