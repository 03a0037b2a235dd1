// summed_height_test: sht of an edge. Entry point of hls/edge/summed_height_test.hpp.
//   in       152 bits  u1, u2, u12 2 x 25 each
//   map       32 bits  width 14, height 14, wrap_u 1, wrap_v 1
//   regs      72 bits  average 1, sum_threshold 44, average_threshold 20
//   table     64 bits a texel, the low 40 a word of the summed-area table
//   out        8 bits  sht 1
//   one word in, one word out a call; initiation interval 48 with one read port: corners beyond two wrapped borders read four words (12
//   where nothing wraps)
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<summed_height_test_in>::value == 150, "the layout above");
static_assert(field_width<map_regs>::value == 30, "the layout above");
static_assert(field_width<summed_height_test_regs>::value == 65, "the layout above");
static_assert(field_width<summed_height_test_out>::value == 1, "the layout above");

void relievo_summed_height_test(port<summed_height_test_in>& in, port_word<map_regs> map, port_word<summed_height_test_regs> regs,
                                std::uint64_t const* table, port<summed_height_test_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=map
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=m_axi port=table offset=slave bundle=table
#pragma HLS INTERFACE mode=s_axilite port=return
#pragma HLS PIPELINE II=48
#else
#pragma HLS INTERFACE mode=m_axi port=table offset=direct
#endif
  // clang-format on
  out.write(pack(summed_height_test(unpack<summed_height_test_in>(in.read()), unpack<map_regs>(map), unpack<summed_height_test_regs>(regs),
                                    table_memory{table})));
}
