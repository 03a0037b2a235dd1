// normal_map: the normals of a whole map from its texels. Entry point of hls/surface/normal_map.hpp.
//   in    16 bits  d 16                            width x height words, row by row from v = 0
//   map   32 bits  width 14, height 14, wrap_u 1, wrap_v 1
//   regs  56 bits  gradient_u 24, gradient_v 24, normal_shift 4
//   out   80 bits  x 14, y 14, n 3 x 16, saturated 1, zero 1; as many words, rows in the order that the builder says
//   one map a call; initiation interval 1; one row later than the texels, two when v wraps
#include "hls/core/streaming_loop.hpp"
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<top::texel_word>::value == 16, "the layout above");
static_assert(field_width<map_regs>::value == 30, "the layout above");
static_assert(field_width<normal_map_regs>::value == 52, "the layout above");
static_assert(field_width<normal_map_out>::value == 78, "the layout above");

void relievo_normal_map(port<top::texel_word>& in, port_word<map_regs> map, port_word<normal_map_regs> regs, port<normal_map_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=map
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=s_axilite port=return
#endif
  // clang-format on
  const map_regs sizes = unpack<map_regs>(map);
  const normal_map_regs gradients = unpack<normal_map_regs>(regs);
  const std::int64_t texels = raw(sizes.width) * raw(sizes.height);
  const std::int64_t turns = texels + raw(sizes.width) * normal_map<top::largest_width>::flush_rows(sizes);
  normal_map<top::largest_width> builder;
  for (std::int64_t i = 0; i < turns; ++i) {
#ifndef __BAMBU__
// clang-format off
#pragma HLS PIPELINE II=1
// clang-format on
#endif
    RELIEVO_STREAMING_LOOP("one turn per texel of the map, then one per texel of the rows that come out last");
    top::texel_word texel = {from_raw<relievo::formats::texel>(0)};
    if (i < texels) texel = unpack<top::texel_word>(in.read());
    normal_map_out normal;
    if (builder.step(texel.d, sizes, gradients, normal)) out.write(pack(normal));
  }
}
