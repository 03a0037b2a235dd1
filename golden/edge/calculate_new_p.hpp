// calculate_new_p: the base-surface position of a new vertex on an edge, k sixteenths of the way (8: the midpoint).
//   P = (P_1 (16 - k) + P_2 k) / 16                                             Doggett & Hirche 2000, section 2.1
//
//   in   p1, p2   position     of the edge's ends;  k   weight
//   out  p        position     the same bits when the ends are exchanged and k becomes 16 - k
//   registers: position
#pragma once
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct calculate_new_p_in {
  glm::dvec3 p1{0}, p2{0};
  double k = 8;
  RELIEVO_FIELDS(p1, p2, k)
};
struct calculate_new_p_out {
  glm::dvec3 p{0};
  RELIEVO_FIELDS(p)
};

template <class Rounding>
calculate_new_p_out calculate_new_p(calculate_new_p_in const& in) {
  constexpr bits sixteenths{2, 4};
  static_assert(fits_double(bits_of<formats::position>() * sixteenths + bits_of<formats::position>() * sixteenths), "position");
  const glm::dvec3 p = (in.p1 * (16 - in.k) + in.p2 * in.k) / 16.0;
  calculate_new_p_out out;
  for (int i = 0; i < 3; ++i) out.p[i] = Rounding::template at<formats::position>(p[i]);
  return out;
}

}  // namespace golden
}  // namespace relievo
