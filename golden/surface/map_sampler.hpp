// map_sampler: the displacement D(u, v), bilinear between the four texels around U.   Doggett & Hirche 2000, eq. 1 (D)
//
//   in   u   coordinate
//   out  d   sample         rounded once, after the whole bilinear sum
//   memory   texels(x, y) -> stored displacement (texel)
//   registers: sample
#pragma once
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "golden/surface/map_address.hpp"
#include "golden/surface/map_regs.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

namespace detail {

// a + t (b - a): a constant map stays that constant in double too.
template <class T>
T between(T const& a, T const& b, double t) {
  return a + t * (b - a);
}

// Exact bilinear interpolation of memory words; the fractions have `coordinate`'s fractional bits each.
template <class Memory>
auto bilinear(map_address_out const& at, Memory const& memory) {
  const auto lower = between(memory(at.x[0], at.y[0]), memory(at.x[1], at.y[0]), at.f.x);
  const auto upper = between(memory(at.x[0], at.y[1]), memory(at.x[1], at.y[1]), at.f.x);
  return between(lower, upper, at.f.y);
}

template <class Stored>
constexpr bool bilinear_fits_double() {
  constexpr bits fraction{1, formats::coordinate::fraction};
  constexpr bits stored{Stored::integer_bits + (Stored::is_signed ? 0 : 1), Stored::fraction};
  constexpr bits row = stored + (stored + stored) * fraction;
  return fits_double(row + (row + row) * fraction);
}

}  // namespace detail

struct map_sampler_in {
  glm::dvec2 u{0};
  RELIEVO_FIELDS(u)
};
struct map_sampler_out {
  double d = 0;
  RELIEVO_FIELDS(d)
};

template <class Rounding, class Texels>
map_sampler_out map_sampler(map_sampler_in const& in, map_regs const& map, Texels const& texels) {
  static_assert(detail::bilinear_fits_double<formats::texel>(), "the bilinear sum must be exact");
  return {Rounding::template at<formats::sample>(detail::bilinear(map_address<Rounding>({in.u}, map), texels))};
}

}  // namespace golden
}  // namespace relievo
