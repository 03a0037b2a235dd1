// summed_area_table: the table of a whole map from its texels. Entry point of hls/surface/summed_area_table.hpp.
//   in    16 bits  d 16                            width x height words, row by row from v = 0
//   map   32 bits  width 14, height 14, wrap_u 1, wrap_v 1
//   out   40 bits  sum 40                          as many words, in the same order
//   one map a call; initiation interval 1
#include "hls/core/streaming_loop.hpp"
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<top::texel_word>::value == 16, "the layout above");
static_assert(field_width<map_regs>::value == 30, "the layout above");
static_assert(field_width<top::table_word>::value == 40, "the layout above");

void relievo_summed_area_table(port<top::texel_word>& in, port_word<map_regs> map, port<top::table_word>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=map
#pragma HLS INTERFACE mode=s_axilite port=return
#endif
  // clang-format on
  const map_regs regs = unpack<map_regs>(map);
  const std::int64_t texels = raw(regs.width) * raw(regs.height);
  summed_area_table<top::largest_width> builder;
  for (std::int64_t i = 0; i < texels; ++i) {
#ifndef __BAMBU__
// clang-format off
#pragma HLS PIPELINE II=1
// clang-format on
#endif
    RELIEVO_STREAMING_LOOP("one turn per texel of the map");
    const top::table_word word = {builder.step(unpack<top::texel_word>(in.read()).d, regs)};
    out.write(pack(word));
  }
}
