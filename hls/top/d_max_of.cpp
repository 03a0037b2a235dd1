// d_max_of: the largest |displacement| of a box of the map. Entry point of d_max_of in hls/sweep/base_triangle_clip.hpp.
//   in       104 bits  low 2 x 25, high 2 x 25
//   map       32 bits  width 14, height 14, wrap_u 1, wrap_v 1
//   regs      48 bits  scale 24, bias 24
//   maximum   16 bits a texel, level after level;  minimum likewise
//   out       24 bits  d_max 24
//   one word in, one word out a call; initiation interval 4 with these one-texel ports
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<d_max_of_in>::value == 100, "the layout above");
static_assert(field_width<map_regs>::value == 30, "the layout above");
static_assert(field_width<displace_regs>::value == 48, "the layout above");
static_assert(field_width<d_max_of_out>::value == 24, "the layout above");

void relievo_d_max_of(port<d_max_of_in>& in, port_word<map_regs> map, port_word<displace_regs> regs, std::uint16_t const* maximum,
                      std::uint16_t const* minimum, port<d_max_of_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=map
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=m_axi port=maximum offset=slave bundle=maximum
#pragma HLS INTERFACE mode=m_axi port=minimum offset=slave bundle=minimum
#pragma HLS INTERFACE mode=s_axilite port=return
#pragma HLS PIPELINE II=4
#else
#pragma HLS INTERFACE mode=m_axi port=maximum offset=direct
#pragma HLS INTERFACE mode=m_axi port=minimum offset=direct
#endif
  // clang-format on
  out.write(pack(d_max_of(unpack<d_max_of_in>(in.read()), unpack<map_regs>(map), unpack<displace_regs>(regs), level_memory{maximum},
                          level_memory{minimum})));
}
