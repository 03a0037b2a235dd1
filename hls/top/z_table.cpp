// z_table: the table of grid_transform. Entry point of hls/sweep/z_table.hpp.
//   regs   32 bits  kappa 32
//   out    40 bits  z 40; 257 words, i = 0 to 256
//   one table a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<top::z_table_regs>::value == 32, "the layout above");
static_assert(field_width<z_table_out>::value == 40, "the layout above");

void relievo_z_table(port_word<top::z_table_regs> regs, port<z_table_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=s_axilite port=return
#endif
  // clang-format on
  const top::z_table_regs camera = unpack<top::z_table_regs>(regs);
  for (int i = 0; i < z_table_words; ++i) {
#ifndef __BAMBU__
// clang-format off
#pragma HLS PIPELINE II=1
// clang-format on
#endif
    out.write(pack(z_table({camera.kappa, from_raw<relievo::format<9, 9, false>>(i)})));
  }
}
