// normal_sampler: bilinear sample of the normal map, N_D(U). Not normalised here: bump normalises the sum.
//   in    u     coordinate[2], texels
//   regs  map   sizes, clamp or wrap per axis; memory packed normals
//   out   n     unit[3]: per component the exact bilinear sum, rounded once
//   one 2 x 2 quad read; initiation interval 1 from a memory of four banks, 4 from one port
#pragma once
#include "hls/surface/map_address.hpp"

namespace relievo {
namespace hls {

struct normal_sampler_in {
  fixed<formats::coordinate> u[2];
  RELIEVO_FIELDS(u)
};
struct normal_sampler_out {
  fixed<formats::unit> n[3];
  RELIEVO_FIELDS(n)
};

inline normal_sampler_out normal_sampler(normal_sampler_in const& in, map_regs const& map, normal_memory const& memory) {
  const map_address_out s0_address = map_address({{in.u[0], in.u[1]}}, map);
  std::uint64_t s1_quad[2][2];
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column)
      s1_quad[row][column] = memory.words[word_index(s0_address.x[column], s0_address.y[row], map)];
  normal_sampler_out out;
  for (int i = 0; i < 3; ++i) {
    const fixed<formats::unit> quad[2][2] = {{unpack_normal(s1_quad[0][0], i), unpack_normal(s1_quad[0][1], i)},
                                             {unpack_normal(s1_quad[1][0], i), unpack_normal(s1_quad[1][1], i)}};
    out.n[i] = round_to<formats::unit>(bilinear(quad, s0_address.f));
  }
  return out;
}

}  // namespace hls
}  // namespace relievo
