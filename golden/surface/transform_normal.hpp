// transform_normal: N'_s, the displaced normal in view space, and whether it points away from the eye.
//   N'_s = R N';  away = N' . (P' - eye) > 0                                      Doggett & Hirche 2000, section 3.1.5
//
//   in    p   position   P'
//         n   unit       N'
//   regs  rotation   unit   three rows;  eye   eye   the eye's world position
//   out   n   unit       N'_s
//         away           decided exactly
//   registers: unit
#pragma once
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct transform_normal_in {
  glm::dvec3 p{0}, n{0};
  RELIEVO_FIELDS(p, n)
};
struct transform_normal_regs {
  glm::dvec3 rotation[3] = {glm::dvec3(0), glm::dvec3(0), glm::dvec3(0)};
  glm::dvec3 eye{0};
  RELIEVO_FIELDS(rotation, eye)
};
struct transform_normal_out {
  glm::dvec3 n{0};
  bool away = false;
  RELIEVO_FIELDS(n, away)
};

template <class Rounding>
transform_normal_out transform_normal(transform_normal_in const& in, transform_normal_regs const& regs) {
  using namespace formats;
  static_assert(fits_double(dot3(bits_of<unit>(), bits_of<unit>())), "N'_s");
  static_assert(fits_double(dot3(bits_of<unit>(), bits_of<position>() + bits_of<formats::eye>())), "away");
  transform_normal_out out;
  for (int i = 0; i < 3; ++i) out.n[i] = Rounding::template at<unit>(glm::dot(regs.rotation[i], in.n));
  const glm::dvec3 ray = in.p - regs.eye;
  out.away = Rounding::exceeds(glm::dot(in.n, ray), 0, glm::length(ray));
  return out;
}

}  // namespace golden
}  // namespace relievo
