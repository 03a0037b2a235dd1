// bump: the displaced surface's normal from the mesh frame and the map's normal.
//   N' = normalize(N m_z + T m_x + B m_y), B = N x T                               Doggett & Hirche 2000, section 2.1
//
//   in   n, t   unit       N and T of the mesh
//        m      unit       normal of the displacement map
//   out  n      unit       N';  saturated: a register clipped;  zero: the sum was the zero vector, N' is (0, 0, 1)
//   registers: unit (B), direction (the sum), unit
#pragma once
#include <glm/glm.hpp>

#include "golden/core/normalize.hpp"
#include "golden/core/rounding.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct bump_in {
  glm::dvec3 n{0}, t{0}, m{0};
  RELIEVO_FIELDS(n, t, m)
};
struct bump_out {
  glm::dvec3 n{0};
  bool saturated = false;
  bool zero = false;
  RELIEVO_FIELDS(n, saturated, zero)
};

template <class Rounding>
bump_out bump(bump_in const& in) {
  static_assert(fits_double(dot3(bits_of<formats::unit>(), bits_of<formats::unit>())), "direction");
  bump_out out;
  glm::dvec3 b = glm::cross(in.n, in.t);
  for (int i = 0; i < 3; ++i) b[i] = Rounding::template at<formats::unit>(b[i], out.saturated);
  glm::dvec3 direction = in.n * in.m.z + in.t * in.m.x + b * in.m.y;
  for (int i = 0; i < 3; ++i) direction[i] = Rounding::template at<formats::direction>(direction[i], out.saturated);
  const normalize_out unit = normalize<Rounding>({direction, false});
  out.n = unit.n;
  out.zero = unit.zero;
  return out;
}

}  // namespace golden
}  // namespace relievo
