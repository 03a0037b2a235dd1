// perspective_preparation: vertex data divided by w, so that it is affine on the screen.               Gumhold & Huettner 1999, section 3.2
//   c = 2^exponent / w, w in LSB of depth;  every attribute times c;  c becomes part of the vertex data
//
//   in   vertex     base_vertex    given words of a corner
//        w          depth          > 0
//        exponent   0..27          of the block that the corner is prepared for, so that c <= 1
//   out  interpolants, c of them in (0, 1]
//   registers: w_mantissa (w to 24 significant bits), inverse_w (c, correctly rounded), interp_*
//
// A block is one triangle with its three corners, or one edge with its two ends alone, so that neighbours have the same words;
// its exponent is the place of the leading one of the smallest w. Nothing saturates: |attribute c| <= |attribute|.
// c is 0 only where its block has w = 1 LSB of depth beside more than 2^27; nothing so close to the eye is in front of it.
//
//   prepare_triangle(p, vertex, w)   corner[3] with the triangle's block; end[e][2] with that of edge e from corner e to (e+1)%3,
//                                    the canonical end first, the one with the lower main coordinate (no step: corner e)
#pragma once
#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/glm.hpp>

#include "golden/core/quotient.hpp"
#include "golden/core/rounding.hpp"
#include "golden/sweep/main_direction.hpp"
#include "golden/sweep/vertex_data.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct perspective_preparation_in {
  base_vertex vertex;
  double w = 0;
  int exponent = 0;
  RELIEVO_FIELDS(vertex, w, exponent)
};

// The place of the leading one of w in LSB of depth.
inline int leading_one(double w) {
  int exponent = 0;
  std::frexp(w, &exponent);
  return exponent - 1 + formats::depth::fraction;
}
template <class... W>
int block_exponent(double w, W... others) {
  return std::min({leading_one(w), leading_one(others)...});
}

// w to as many significant bits as w_mantissa has, half up; 2^k - 1/2 LSB and more become 2^k.
template <class Rounding>
double significant_w(double w) {
  if constexpr (Rounding::is_exact) return w;
  const double lsb = power_of_two(leading_one(w) + 1 - formats::depth::fraction - formats::w_mantissa::fraction);
  return round_half_up(w / lsb) * lsb;
}

template <class Rounding = rounded>
interpolants perspective_preparation(perspective_preparation_in const& in) {
  interpolants out;
  bool clipped = false;
  const double block = power_of_two(in.exponent - formats::depth::fraction);
  out.c = quotient<Rounding, formats::inverse_w, formats::w_mantissa::width>(block, significant_w<Rounding>(in.w), clipped);
  each_attribute(
      [&](auto f, double const& given, double& interpolant) {
        using F = decltype(f);
        static_assert(fits_double(bits_of<typename F::given>() * bits_of<formats::inverse_w>()), "interpolant");
        interpolant = Rounding::template at<typename F::interp>(given * out.c, clipped);
      },
      in.vertex, out);
  assert(!clipped && "w is nearer than its block");
  return out;
}

struct prepared_triangle {
  interpolants corner[3];
  interpolants end[3][2];
};

template <class Rounding = rounded>
prepared_triangle prepare_triangle(glm::dvec3 const (&p)[3], base_vertex const (&vertex)[3], double const (&w)[3]) {
  prepared_triangle out;
  const int block = block_exponent(w[0], w[1], w[2]);
  for (int e = 0; e < 3; ++e) {
    const int next = (e + 1) % 3, axis = main_direction({{p[e], p[next]}}).axis;
    const bool rising = p[e][axis] <= p[next][axis];
    const int canonical = rising ? e : next, other = rising ? next : e, edge = block_exponent(w[e], w[next]);
    out.corner[e] = perspective_preparation<Rounding>({vertex[e], w[e], block});
    out.end[e][0] = perspective_preparation<Rounding>({vertex[canonical], w[canonical], edge});
    out.end[e][1] = perspective_preparation<Rounding>({vertex[other], w[other], edge});
  }
  return out;
}

}  // namespace golden
}  // namespace relievo
