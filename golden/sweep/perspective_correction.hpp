// perspective_correction: interpolated vertex data back in the world.               Gumhold & Huettner 1999, section 3.2, Figure 5
//   x / c for every attribute x, as (x 2^shift) (1 / (c 2^shift)) with c 2^shift in [1/2, 1];  N and T made unit vectors again (2.1)
//
//   in   v          vertex_steps   c > 0
//   regs limit      coordinate     the largest coordinate of each axis: W - 1 where it is clamped, W where it wraps
//   out  p          position
//        n, t       unit           of length 0: (0, 0, 1) and (1, 0, 0)
//        u          coordinate     in [0, limit];  colour   colour, not below 0
//        w_correction   correction;  shift   0..41, 0 from c = 1 on: w_correction 2^shift is 1/c
//        saturated      a register clipped. An interpolant may fall short of 0 or pass the limit by its rounding: that is none
//   registers: normalised_c (c 2^shift), correction (correctly rounded), interp_* (x 2^shift), position, direction,
//              coordinate, colour, unit
//
// Error of the whole path from the corners' words, h the LSB of the interpolant, R the attribute's range over the corners, x the
// attribute, q = 1/c <= 2 w / w_min of the block:
//   (3/4 h + |x| 2^-28 + R 2^-27) q + h + 3/2 |x| 2^-25 + R 2^-25 + 1/2 LSB                           docs/error_budget.md, "The sweep"
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "golden/core/normalize.hpp"
#include "golden/core/quotient.hpp"
#include "golden/core/rounding.hpp"
#include "golden/sweep/vertex_data.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct perspective_correction_in {
  vertex_steps v;
  RELIEVO_FIELDS(v)
};
struct perspective_correction_regs {
  glm::dvec2 limit{0};
  RELIEVO_FIELDS(limit)
};
struct perspective_correction_out {
  glm::dvec3 p{0}, n{0}, t{0};
  glm::dvec2 u{0};
  glm::dvec4 colour{0};
  double w_correction = 0;
  int shift = 0;
  bool saturated = false;
  RELIEVO_FIELDS(p, n, t, u, colour, w_correction, shift, saturated)
};

// c 2^shift, 25 fractional bits.
using normalised_c = format<26, 1, false>;

// The shift that brings the leading one of c to 1/2.
inline int correction_shift(double c) {
  int exponent = 0;
  std::frexp(c, &exponent);
  return exponent < 0 ? -exponent : 0;
}

template <class Rounding = rounded>
perspective_correction_out perspective_correction(perspective_correction_in const& in, perspective_correction_regs const& regs) {
  perspective_correction_out out;
  out.shift = correction_shift(in.v.c);
  const double scale = power_of_two(out.shift);
  const double c = Rounding::template at<normalised_c>(in.v.c * scale, out.saturated);
  out.w_correction = quotient<Rounding, formats::correction, normalised_c::width>(1, c, out.saturated);

  // A product's magnitude is at most 2^27 x 2^25 LSB, as the correction is at most 2.
  static_assert((formats::interp_position::width - 1) + (formats::correction::width - 1) <= 53, "product");
  const auto corrected = [&](auto f, double x) {
    return Rounding::template at<typename decltype(f)::interp>(x * scale, out.saturated) * out.w_correction;
  };
  const auto from_zero = [](double x) { return x < 0 ? 0 : x; };
  glm::dvec3 n, t;
  for (int i = 0; i < 3; ++i) {
    out.p[i] = Rounding::template at<formats::position>(corrected(position_formats{}, in.v.p[i]), out.saturated);
    n[i] = Rounding::template at<formats::direction>(corrected(unit_formats{}, in.v.n[i]), out.saturated);
    t[i] = Rounding::template at<formats::direction>(corrected(unit_formats{}, in.v.t[i]), out.saturated);
  }
  for (int i = 0; i < 2; ++i) {
    const double u = from_zero(corrected(coordinate_formats{}, in.v.u[i]));
    out.u[i] = std::min(Rounding::template at<formats::coordinate>(u, out.saturated), regs.limit[i]);
  }
  for (int i = 0; i < 4; ++i)
    out.colour[i] = Rounding::template at<formats::colour>(from_zero(corrected(colour_formats{}, in.v.colour[i])), out.saturated);
  out.n = normalize<Rounding>({n, false}).n;
  out.t = normalize<Rounding>({t, true}).n;
  return out;
}

}  // namespace golden
}  // namespace relievo
