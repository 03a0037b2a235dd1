// perspective_correction: the data of a vertex in the world again.
//   P = (P c) / c and so on; N and T are of length 1 again                  Gumhold & Huettner 1999, 3.2, last stage of Figure 5; 2.1
//   in    v      vertex_steps, c > 0
//   regs  limit  coordinate[2], the largest of each axis: W - 1 where it clamps, W where it wraps
//   out   p position[3], n and t unit[3], u coordinate[2], colour[4]
//         w_correction  1/c, normalised;  shift  0 to 41, the power of two taken out of it: 1/c is w_correction 2^shift
//         saturated     a register clipped; a coordinate at its limit, or one or a colour below 0, is none
//   s0_shift: brings c's leading bit to 1/2 (0 for c >= 1);  s0_c = c 2^shift (25 fractional bits);  s1_w = 1 / s0_c (correction)
//   s1_x = x 2^shift (in x's interp format);  s2 = s1_x s1_w: position, direction, coordinate, colour; then normalize
//   Against x / c: s0_c and s1_w are right to 2^-25 of themselves each, so 2^-24 |x / c|, an LSB of interp for s1_x, half an LSB for s2.
//   initiation interval 1
#pragma once
#include "hls/core/normalize.hpp"
#include "hls/core/reciprocal.hpp"
#include "hls/sweep/vertex_data.hpp"

namespace relievo {
namespace hls {

struct perspective_correction_in {
  vertex_steps v;
  RELIEVO_FIELDS(v)
};
struct perspective_correction_regs {
  fixed<formats::coordinate> limit[2];
  RELIEVO_FIELDS(limit)
};
struct perspective_correction_out {
  fixed<formats::position> p[3];
  fixed<formats::unit> n[3];
  fixed<formats::unit> t[3];
  fixed<formats::coordinate> u[2];
  fixed<formats::colour> colour[4];
  fixed<formats::correction> w_correction;
  fixed<format<6, 6, false>> shift;
  bool saturated;
  RELIEVO_FIELDS(p, n, t, u, colour, w_correction, shift, saturated)
};

namespace detail {

// What is no vertex, c <= 0, takes any way through.
inline int shift_of(fixed<formats::step_c> c) {
  constexpr int half = formats::step_c::fraction - 1;
  std::int64_t left = raw(c) > 0 ? raw(c) : 1;
  int shift = 0;
  for (int step = 32; step >= 1; step >>= 1)
    if (left < (std::int64_t(1) << (half + 1 - step))) {
      left <<= step;
      shift += step;
    }
  return shift;
}

// x 2^shift, rounded and saturated. Beyond 2^width of To all is saturated, and might not fit 64 bits.
template <class To, class From>
inline fixed<To> scaled(fixed<From> x, int shift, bool& clipped) {
  const std::int64_t limit = (std::int64_t(1) << (To::width + From::fraction - To::fraction)) >> shift;
  const std::int64_t held = raw(x) > limit ? limit : raw(x) < -limit ? -limit : raw(x);
  return round_to<To>(from_raw<From>(held * (std::int64_t(1) << shift)), clipped);
}

struct corrected {
  fixed<formats::correction> w;
  int shift;
  bool& saturated;

  template <class Interp, class To, class From>
  void component(fixed<To>& out, fixed<From> const& x) const {
    const auto s1_x = scaled<Interp>(x, shift, saturated);
    const auto product = s1_x * w;
    out = !To::is_signed && raw(product) < 0 ? from_raw<To>(0) : round_to<To>(product, saturated);
  }
};

}  // namespace detail

inline perspective_correction_out perspective_correction(perspective_correction_in const& in, perspective_correction_regs const& regs) {
  perspective_correction_out out;
  out.saturated = false;
  const int s0_shift = detail::shift_of(in.v.c);
  bool beyond = false;
  const auto s0_c = detail::scaled<format<26, 1, false>>(in.v.c, s0_shift, beyond);
  out.w_correction = reciprocal<formats::correction>(s0_c, beyond);
  out.shift = from_raw<format<6, 6, false>>(s0_shift);

  const detail::corrected correct = {out.w_correction, s0_shift, out.saturated};
  normalize_in s2_n, s2_t;
  s2_n.tangent = false;
  s2_t.tangent = true;
  for (int i = 0; i < 3; ++i) {
    correct.component<formats::interp_position>(out.p[i], in.v.p[i]);
    correct.component<formats::interp_unit>(s2_n.v[i], in.v.n[i]);
    correct.component<formats::interp_unit>(s2_t.v[i], in.v.t[i]);
  }
  for (int i = 0; i < 2; ++i) {
    fixed<formats::coordinate> s2_u;
    correct.component<formats::interp_coordinate>(s2_u, in.v.u[i]);
    out.u[i] = s2_u > regs.limit[i] ? regs.limit[i] : s2_u;
  }
  for (int i = 0; i < 4; ++i) correct.component<formats::interp_colour>(out.colour[i], in.v.colour[i]);
  const normalize_out n = normalize(s2_n), t = normalize(s2_t);
  for (int i = 0; i < 3; ++i) {
    out.n[i] = n.n[i];
    out.t[i] = t.n[i];
  }
  return out;
}

}  // namespace hls
}  // namespace relievo
