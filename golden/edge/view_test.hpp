// view_test: is the displaced edge still long on the screen?
//   vt = |dx| + |dy| > vthr, the Manhattan distance of the ends' P'_s             Doggett & Hirche 2000, section 2.4
//
//   in    screen1, screen2   screen;  behind1, behind2   an end at or behind the eye: vt is true, the other tests decide
//   regs  threshold          view_threshold
//   out   vt                 exact
#pragma once
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct view_test_in {
  glm::dvec2 screen1{0}, screen2{0};
  bool behind1 = false, behind2 = false;
  RELIEVO_FIELDS(screen1, screen2, behind1, behind2)
};
struct view_test_regs {
  double threshold = 0;
  RELIEVO_FIELDS(threshold)
};
struct view_test_out {
  bool vt = false;
  RELIEVO_FIELDS(vt)
};

inline double view_test_measure(view_test_in const& in) {
  const glm::dvec2 d = glm::abs(in.screen1 - in.screen2);
  return d.x + d.y;
}

template <class Rounding>
view_test_out view_test(view_test_in const& in, view_test_regs const& regs) {
  const double scale = glm::length(in.screen1) + glm::length(in.screen2);
  return {in.behind1 || in.behind2 || Rounding::exceeds(view_test_measure(in), regs.threshold, scale)};
}

}  // namespace golden
}  // namespace relievo
