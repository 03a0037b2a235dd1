// divide: clip / depth, the quotient a screen coordinate. Entry point of hls/core/divide.hpp.
//   in        72 bits  numerator 38, denominator 28
//   out       24 bits  quotient 22, clipped 1
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;
namespace formats = relievo::formats;

static_assert(field_width<top::divide_in>::value == 66, "the layout above");
static_assert(field_width<top::divide_out>::value == 23, "the layout above");

void relievo_divide(port<top::divide_in>& in, port<top::divide_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  const top::divide_in x = unpack<top::divide_in>(in.read());
  top::divide_out y;
  y.clipped = false;
  y.quotient = divide<formats::screen>(x.numerator, x.denominator, y.clipped);
  out.write(pack(y));
}
