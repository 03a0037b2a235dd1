// perspective_preparation: a corner's data times c. Entry point of hls/sweep/perspective_preparation.hpp.
//   in       320 bits  p 3 x 24, n 3 x 16, t 3 x 16, u 2 x 25, colour 4 x 16, w 28, exponent 5
//   out      448 bits  p, n, t 3 x 28 each, u 2 x 28, colour 4 x 28, c 28
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<perspective_preparation_in>::value == 315, "the layout above");
static_assert(field_width<interpolants>::value == 448, "the layout above");

void relievo_perspective_preparation(port<perspective_preparation_in>& in, port<interpolants>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(perspective_preparation(unpack<perspective_preparation_in>(in.read()))));
}
