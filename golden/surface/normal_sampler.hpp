// normal_sampler: the map's normal N_D at U, bilinear per component, not renormalised.  Doggett & Hirche 2000, section 2.1
//
//   in   u   coordinate
//   out  n   unit           rounded once per component
//   memory   normals(x, y) -> normal map, unit[3]
//   registers: unit
#pragma once
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "golden/surface/map_address.hpp"
#include "golden/surface/map_regs.hpp"
#include "golden/surface/map_sampler.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct normal_sampler_in {
  glm::dvec2 u{0};
  RELIEVO_FIELDS(u)
};
struct normal_sampler_out {
  glm::dvec3 n{0};
  RELIEVO_FIELDS(n)
};

template <class Rounding, class Normals>
normal_sampler_out normal_sampler(normal_sampler_in const& in, map_regs const& map, Normals const& normals) {
  static_assert(detail::bilinear_fits_double<formats::unit>(), "the bilinear sum must be exact");
  const glm::dvec3 n = detail::bilinear(map_address<Rounding>({in.u}, map), normals);
  normal_sampler_out out;
  for (int i = 0; i < 3; ++i) out.n[i] = Rounding::template at<formats::unit>(n[i]);
  return out;
}

}  // namespace golden
}  // namespace relievo
