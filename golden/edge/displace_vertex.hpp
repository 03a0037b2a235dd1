// displace_vertex: P' of a vertex, the displacement read from the map.           Doggett & Hirche 2000, eq. 1, section 3
//   P' = P + (s D(U) + b) N
//
//   in    p   position, n   unit, u   coordinate
//   regs  map_regs; displace_regs
//   out   p   position     saturated: a register clipped
//   memory   texels(x, y) -> stored displacement (texel)
//   registers: those of map_sampler and displace
#pragma once
#include <glm/glm.hpp>

#include "golden/surface/displace.hpp"
#include "golden/surface/map_sampler.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct displace_vertex_in {
  glm::dvec3 p{0}, n{0};
  glm::dvec2 u{0};
  RELIEVO_FIELDS(p, n, u)
};
struct displace_vertex_out {
  glm::dvec3 p{0};
  bool saturated = false;
  RELIEVO_FIELDS(p, saturated)
};

template <class Rounding, class Texels>
displace_vertex_out displace_vertex(displace_vertex_in const& in, map_regs const& map, displace_regs const& regs, Texels const& texels) {
  const double d = map_sampler<Rounding>({in.u}, map, texels).d;
  const displace_out moved = displace<Rounding>({in.p, in.n, d}, regs);
  return {moved.p, moved.saturated};
}

}  // namespace golden
}  // namespace relievo
