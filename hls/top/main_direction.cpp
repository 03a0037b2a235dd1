// main_direction: the axis along which an edge is subdivided, and its steps. Entry point of hls/sweep/main_direction.hpp.
//   in       96 bits  p 2 x 3 x 16
//   out      24 bits  axis 2, n 16
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<main_direction_in>::value == 96, "the layout above");
static_assert(field_width<main_direction_out>::value == 18, "the layout above");

void relievo_main_direction(port<main_direction_in>& in, port<main_direction_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(main_direction(unpack<main_direction_in>(in.read()))));
}
