// map_sampler: bilinear sample of the displacement map, D(U).
//   in    u     coordinate[2], texels
//   regs  map   sizes, clamp or wrap per axis; memory texels
//   out   d     sample: the exact bilinear sum of four texels, rounded once
//   one 2 x 2 quad read; initiation interval 1 from a memory of four banks, 4 from one port
#pragma once
#include "hls/surface/map_address.hpp"

namespace relievo {
namespace hls {

struct map_sampler_in {
  fixed<formats::coordinate> u[2];
  RELIEVO_FIELDS(u)
};
struct map_sampler_out {
  fixed<formats::sample> d;
  RELIEVO_FIELDS(d)
};

inline map_sampler_out map_sampler(map_sampler_in const& in, map_regs const& map, texel_memory const& memory) {
  const map_address_out s0_address = map_address({{in.u[0], in.u[1]}}, map);
  fixed<formats::texel> s1_quad[2][2];
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column)
      s1_quad[row][column] = from_raw<formats::texel>(memory.words[word_index(s0_address.x[column], s0_address.y[row], map)]);
  map_sampler_out out;
  out.d = round_to<formats::sample>(bilinear(s1_quad, s0_address.f));
  return out;
}

}  // namespace hls
}  // namespace relievo
