// tex_coord_test: is the new vertex in a texel of its own?                       Doggett & Hirche 2000, section 2.5
//   ct = false when the integer parts of U_12 equal those of U_1, or those of U_2
//
//   in   u1, u2, u12   coordinate   in texels
//   out  ct                         exact
#pragma once
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct tex_coord_test_in {
  glm::dvec2 u1{0}, u2{0}, u12{0};
  RELIEVO_FIELDS(u1, u2, u12)
};
struct tex_coord_test_out {
  bool ct = false;
  RELIEVO_FIELDS(ct)
};

template <class Rounding>
tex_coord_test_out tex_coord_test(tex_coord_test_in const& in) {
  const glm::dvec2 texel = glm::floor(in.u12);
  return {texel != glm::floor(in.u1) && texel != glm::floor(in.u2)};
}

}  // namespace golden
}  // namespace relievo
