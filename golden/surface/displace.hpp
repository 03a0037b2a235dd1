// displace: P' = P + (s D + b) N.                                                Doggett & Hirche 2000, eq. 1 and 5.1
//
//   in    p   position     on the base surface
//         n   unit         N there
//         d   sample       filtered displacement
//   regs  scale   scale    world units per sample;  bias   height
//   out   p   position     saturated: a register clipped
//   registers: height (s D + b), position
#pragma once
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct displace_in {
  glm::dvec3 p{0}, n{0};
  double d = 0;
  RELIEVO_FIELDS(p, n, d)
};
struct displace_regs {
  double scale = 0;
  double bias = 0;
  RELIEVO_FIELDS(scale, bias)
};
struct displace_out {
  glm::dvec3 p{0};
  bool saturated = false;
  RELIEVO_FIELDS(p, saturated)
};

template <class Rounding>
displace_out displace(displace_in const& in, displace_regs const& regs) {
  static_assert(fits_double(bits_of<formats::scale>() * bits_of<formats::sample>() + bits_of<formats::height>()), "height");
  static_assert(fits_double(bits_of<formats::height>() * bits_of<formats::unit>() + bits_of<formats::position>()), "position");
  displace_out out;
  const double height = Rounding::template at<formats::height>(regs.scale * in.d + regs.bias, out.saturated);
  const glm::dvec3 p = in.p + height * in.n;
  for (int i = 0; i < 3; ++i) out.p[i] = Rounding::template at<formats::position>(p[i], out.saturated);
  return out;
}

}  // namespace golden
}  // namespace relievo
