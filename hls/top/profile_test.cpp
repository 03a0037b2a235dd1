// profile_test: pt of an edge, and where its new vertex goes. Entry point of hls/edge/profile_test.hpp.
//   in       104 bits  u1, u2 2 x 25 each, forward 1
//   map       32 bits  width 14, height 14, wrap_u 1, wrap_v 1
//   regs      24 bits  threshold 20
//   texels    16 bits a texel, displacement
//   out        8 bits  pt 1, k 5
//   one word in, one word out a call; initiation interval 68 with this one-texel port: 17 quads of four
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<profile_test_in>::value == 101, "the layout above");
static_assert(field_width<map_regs>::value == 30, "the layout above");
static_assert(field_width<profile_test_regs>::value == 20, "the layout above");
static_assert(field_width<profile_test_out>::value == 6, "the layout above");

void relievo_profile_test(port<profile_test_in>& in, port_word<map_regs> map, port_word<profile_test_regs> regs,
                          std::uint16_t const* texels, port<profile_test_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=map
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=m_axi port=texels offset=slave bundle=texels
#pragma HLS INTERFACE mode=s_axilite port=return
#pragma HLS PIPELINE II=68
#else
#pragma HLS INTERFACE mode=m_axi port=texels offset=direct
#endif
  // clang-format on
  out.write(
      pack(profile_test(unpack<profile_test_in>(in.read()), unpack<map_regs>(map), unpack<profile_test_regs>(regs), texel_memory{texels})));
}
