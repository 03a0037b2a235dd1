// calculate_new_u: the texture coordinate of a new vertex on an edge, k sixteenths of the way (8: the midpoint).
//   U = (U_1 (16 - k) + U_2 k) / 16                                             Doggett & Hirche 2000, section 2.1
//
//   in   u1, u2   coordinate     of the edge's ends;  k   weight
//   out  u        coordinate     the same bits when the ends are exchanged and k becomes 16 - k
//   registers: coordinate
#pragma once
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct calculate_new_u_in {
  glm::dvec2 u1{0}, u2{0};
  double k = 8;
  RELIEVO_FIELDS(u1, u2, k)
};
struct calculate_new_u_out {
  glm::dvec2 u{0};
  RELIEVO_FIELDS(u)
};

template <class Rounding>
calculate_new_u_out calculate_new_u(calculate_new_u_in const& in) {
  constexpr bits sixteenths{2, 4};
  static_assert(fits_double(bits_of<formats::coordinate>() * sixteenths + bits_of<formats::coordinate>() * sixteenths), "coordinate");
  const glm::dvec2 u = (in.u1 * (16 - in.k) + in.u2 * in.k) / 16.0;
  calculate_new_u_out out;
  for (int i = 0; i < 2; ++i) out.u[i] = Rounding::template at<formats::coordinate>(u[i]);
  return out;
}

}  // namespace golden
}  // namespace relievo
