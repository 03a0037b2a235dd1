// normal_test: does the surface turn between an end of the edge and its new vertex?
//   nt = any component of |N'_12 - N'_1| or |N'_12 - N'_2| > nthr                  Doggett & Hirche 2000, section 2.2
//
//   in    n1, n2, n12   unit               N' of the ends and of the new vertex
//   regs  threshold     normal_threshold
//   out   nt                               exact
//
// The paper prints signed differences below the threshold; the sentence above its formula says what is meant.
#pragma once
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct normal_test_in {
  glm::dvec3 n1{0}, n2{0}, n12{0};
  RELIEVO_FIELDS(n1, n2, n12)
};
struct normal_test_regs {
  double threshold = 0;
  RELIEVO_FIELDS(threshold)
};
struct normal_test_out {
  bool nt = false;
  RELIEVO_FIELDS(nt)
};

// The largest of the six differences.
inline double normal_test_measure(normal_test_in const& in) {
  const glm::dvec3 d = glm::max(glm::abs(in.n12 - in.n1), glm::abs(in.n12 - in.n2));
  return glm::max(d.x, glm::max(d.y, d.z));
}

template <class Rounding>
normal_test_out normal_test(normal_test_in const& in, normal_test_regs const& regs) {
  return {Rounding::exceeds(normal_test_measure(in), regs.threshold, 1)};
}

}  // namespace golden
}  // namespace relievo
