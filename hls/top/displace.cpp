// displace: P' = P + (s D + b) N. Entry point of hls/surface/displace.hpp.
//   in       144 bits  p 3 x 24, n 3 x 16, d 20
//   regs      48 bits  scale 24, bias 24
//   out       80 bits  p 3 x 24, saturated 1
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<displace_in>::value == 140, "the layout above");
static_assert(field_width<displace_regs>::value == 48, "the layout above");
static_assert(field_width<displace_out>::value == 73, "the layout above");

void relievo_displace(port<displace_in>& in, port_word<displace_regs> regs, port<displace_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(displace(unpack<displace_in>(in.read()), unpack<displace_regs>(regs))));
}
