// highlight_test: is an end of the edge or its new vertex inside the Phong highlight?
//   ht = any N' . H > threshold                                                    Doggett & Hirche 2000, section 5.1
//
//   in    n1, n2, n12   unit    N' of the ends and of the new vertex
//   regs  half_vector   unit    H: directional light, viewer at infinity, so that the test stays edge-only
//         threshold     unit
//   out   ht                    exact
#pragma once
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct highlight_test_in {
  glm::dvec3 n1{0}, n2{0}, n12{0};
  RELIEVO_FIELDS(n1, n2, n12)
};
struct highlight_test_regs {
  glm::dvec3 half_vector{0};
  double threshold = 0;
  RELIEVO_FIELDS(half_vector, threshold)
};
struct highlight_test_out {
  bool ht = false;
  RELIEVO_FIELDS(ht)
};

// The largest of the three products.
inline double highlight_test_measure(highlight_test_in const& in, highlight_test_regs const& regs) {
  static_assert(fits_double(dot3(bits_of<formats::unit>(), bits_of<formats::unit>())), "N' . H");
  return glm::max(glm::dot(in.n12, regs.half_vector), glm::max(glm::dot(in.n1, regs.half_vector), glm::dot(in.n2, regs.half_vector)));
}

template <class Rounding>
highlight_test_out highlight_test(highlight_test_in const& in, highlight_test_regs const& regs) {
  return {Rounding::exceeds(highlight_test_measure(in, regs), regs.threshold, 1)};
}

}  // namespace golden
}  // namespace relievo
