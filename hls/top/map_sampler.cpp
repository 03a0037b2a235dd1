// map_sampler: D(U), bilinear. Entry point of hls/surface/map_sampler.hpp.
//   in        56 bits  u 2 x 25
//   map       32 bits  width 14, height 14, wrap_u 1, wrap_v 1
//   texels    16 bits a texel, displacement
//   out       24 bits  d 20
//   one word in, one word out a call; initiation interval 4 with this one-texel port; the unit itself takes 1 from four banks
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<map_sampler_in>::value == 50, "the layout above");
static_assert(field_width<map_regs>::value == 30, "the layout above");
static_assert(field_width<map_sampler_out>::value == 20, "the layout above");

void relievo_map_sampler(port<map_sampler_in>& in, port_word<map_regs> map, std::uint16_t const* texels, port<map_sampler_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=map
#pragma HLS INTERFACE mode=m_axi port=texels offset=slave bundle=texels
#pragma HLS INTERFACE mode=s_axilite port=return
#pragma HLS PIPELINE II=4
#else
#pragma HLS INTERFACE mode=m_axi port=texels offset=direct
#endif
  // clang-format on
  out.write(pack(map_sampler(unpack<map_sampler_in>(in.read()), unpack<map_regs>(map), texel_memory{texels})));
}
