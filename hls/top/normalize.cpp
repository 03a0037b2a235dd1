// normalize: v / |v|. Entry point of hls/core/normalize.hpp.
//   in        56 bits  v 3 x 18, tangent 1
//   out       56 bits  n 3 x 16, zero 1
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<normalize_in>::value == 55, "the layout above");
static_assert(field_width<normalize_out>::value == 49, "the layout above");

void relievo_normalize(port<normalize_in>& in, port<normalize_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(normalize(unpack<normalize_in>(in.read()))));
}
