// summed_area_lookup: the sum of the map over a rectangle. Entry point of hls/surface/summed_area_lookup.hpp.
//   in        64 bits  x0, y0, x1, y1 16 each
//   map       32 bits  width 14, height 14, wrap_u 1, wrap_v 1
//   table     64 bits a texel, the low 40 a word of the summed-area table
//   out       48 bits  s 45
//   one word in, one word out a call; initiation interval 16 with one read port: a corner beyond two wrapped borders reads four words (4
//   where nothing wraps). Bounds reach at most 6 turns beyond a wrapped axis and rectangles hold at most 4096 x 4096 texels
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<summed_area_lookup_in>::value == 64, "the layout above");
static_assert(field_width<map_regs>::value == 30, "the layout above");
static_assert(field_width<summed_area_lookup_out>::value == 45, "the layout above");

void relievo_summed_area_lookup(port<summed_area_lookup_in>& in, port_word<map_regs> map, std::uint64_t const* table,
                                port<summed_area_lookup_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=map
#pragma HLS INTERFACE mode=m_axi port=table offset=slave bundle=table
#pragma HLS INTERFACE mode=s_axilite port=return
#pragma HLS PIPELINE II=16
#else
#pragma HLS INTERFACE mode=m_axi port=table offset=direct
#endif
  // clang-format on
  out.write(pack(summed_area_lookup(unpack<summed_area_lookup_in>(in.read()), unpack<map_regs>(map), table_memory{table})));
}
