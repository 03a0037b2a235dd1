// normal_map: the unit normal of the scaled displacement map at a texel, by finite differences.
//   n = normalize(-s dD/du, -s dD/dv, 1), dD/du = (D(x+1) - D(x-1)) / (2 du)      Doggett & Hirche 2000, sections 2.1 and 5.1
//
//   in    x, y            the texel
//   regs  gradient_u, gradient_v   gradient   s/(2 du) 2^-e, s/(2 dv) 2^-e
//         normal_shift             shift      e, chosen by the host so that steep maps fit `direction`
//   out   x, y            the texel's address, n   unit,  saturated: the direction clipped,  zero: it was the zero vector
//   memory   texels(x, y) -> stored displacement (texel)
//   registers: direction (-gradient * difference), unit
//
// Clamped borders take the one-sided difference, doubled; an axis of one texel has slope 0. Wrapped axes close on themselves.
#pragma once
#include <glm/glm.hpp>

#include "golden/core/normalize.hpp"
#include "golden/core/rounding.hpp"
#include "golden/surface/map_regs.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct normal_map_in {
  int x = 0, y = 0;
  RELIEVO_FIELDS(x, y)
};
struct normal_map_regs {
  double gradient_u = 0, gradient_v = 0;
  double normal_shift = 0;
  RELIEVO_FIELDS(gradient_u, gradient_v, normal_shift)
};
struct normal_map_out {
  int x = 0, y = 0;
  glm::dvec3 n{0};
  bool saturated = false;
  bool zero = false;
  RELIEVO_FIELDS(x, y, n, saturated, zero)
};

namespace detail {

// D(i+1) - D(i-1) along one axis, `d` giving the texel at an index on it.
template <class Line>
double central_difference(int i, int size, bool wrap, Line const& d) {
  if (wrap) return d((i + 1) % size) - d((i + size - 1) % size);
  if (size == 1) return 0;
  if (i == 0) return 2 * (d(1) - d(0));
  if (i == size - 1) return 2 * (d(i) - d(i - 1));
  return d(i + 1) - d(i - 1);
}

}  // namespace detail

template <class Rounding, class Texels>
normal_map_out normal_map(normal_map_in const& in, map_regs const& map, normal_map_regs const& regs, Texels const& texels) {
  constexpr bits difference{formats::texel::width + 2, 0};
  static_assert(fits_double(bits_of<formats::gradient>() * difference), "direction");
  const double du = detail::central_difference(in.x, static_cast<int>(map.width), map.wrap_u, [&](int i) { return texels(i, in.y); });
  const double dv = detail::central_difference(in.y, static_cast<int>(map.height), map.wrap_v, [&](int i) { return texels(in.x, i); });
  normal_map_out out;
  out.x = in.x;
  out.y = in.y;
  const glm::dvec3 direction(Rounding::template at<formats::direction>(-regs.gradient_u * du, out.saturated),
                             Rounding::template at<formats::direction>(-regs.gradient_v * dv, out.saturated),
                             Rounding::template at<formats::direction>(power_of_two(-static_cast<int>(regs.normal_shift))));
  const normalize_out unit = normalize<Rounding>({direction, false});
  out.n = unit.n;
  out.zero = unit.zero;
  return out;
}

}  // namespace golden
}  // namespace relievo
