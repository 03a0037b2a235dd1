// calculate_new_n: the mesh normal (or tangent) of a new vertex on an edge, k sixteenths of the way.
//   N = normalize(N_1 (16 - k) + N_2 k)                                           Doggett & Hirche 2000, sections 2.1 and 3.1.4
//
//   in   n1, n2   unit      of the edge's ends;  k   weight;  tangent   a zero sum becomes (1, 0, 0), else (0, 0, 1)
//   out  n        unit      zero: the sum was the zero vector
//   registers: direction (an eighth of the sum, twice the mean, so that the midpoint loses nothing), unit
#pragma once
#include <glm/glm.hpp>

#include "golden/core/normalize.hpp"
#include "golden/core/rounding.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct calculate_new_n_in {
  glm::dvec3 n1{0}, n2{0};
  double k = 8;
  bool tangent = false;
  RELIEVO_FIELDS(n1, n2, k, tangent)
};
struct calculate_new_n_out {
  glm::dvec3 n{0};
  bool zero = false;
  RELIEVO_FIELDS(n, zero)
};

template <class Rounding>
calculate_new_n_out calculate_new_n(calculate_new_n_in const& in) {
  constexpr bits eighths{3, 3};
  static_assert(fits_double(bits_of<formats::unit>() * eighths + bits_of<formats::unit>() * eighths), "direction");
  glm::dvec3 direction = (in.n1 * (16 - in.k) + in.n2 * in.k) / 8.0;
  for (int i = 0; i < 3; ++i) direction[i] = Rounding::template at<formats::direction>(direction[i]);
  const normalize_out unit = normalize<Rounding>({direction, in.tangent});
  return {unit.n, unit.zero};
}

}  // namespace golden
}  // namespace relievo
