// perspective_preparation: the data of a corner times c, so that it can be interpolated in the grid.
//   c = 2^exponent / w;  P c, N c, T c, U c, C c, c            Gumhold & Huettner 1999, 3.2, equations (5) and (6)
//   One exponent, block_exponent, for the corners of a triangle and one for the two ends of an edge alone, so that the triangles
//   at the edge have the same words: the nearest corner has c in (1/2, 1], whatever far / near is.
//   in    vertex    base_vertex
//         w         depth, not 0
//         exponent  of the block: at most the index of w's leading bit
//   out   interpolants
//   registers: s0_w (24 significant bits, half up), s1_c (inverse_w, correctly rounded), each component; nothing saturates, as c <= 1
//   initiation interval 1
#pragma once
#include "hls/core/divide.hpp"
#include "hls/sweep/vertex_data.hpp"

namespace relievo {
namespace hls {

using block_power = fixed<format<5, 5, false>>;

struct perspective_preparation_in {
  base_vertex vertex;
  fixed<formats::depth> w;
  block_power exponent;
  RELIEVO_FIELDS(vertex, w, exponent)
};

namespace detail {

// Index of the leading bit, 0 to 27; 0 for 0 too.
inline int leading_bit(fixed<formats::depth> w) {
  std::int64_t left = raw(w);
  int index = 0;
  for (int step = 16; step >= 1; step >>= 1)
    if (left >> step != 0) {
      left >>= step;
      index += step;
    }
  return index;
}

// w as mantissa times 2^(power + 1): a round number of 2^24 becomes 2^23 of twice the power.
struct normalised_w {
  fixed<formats::w_mantissa> mantissa;
  int power;
};
inline normalised_w normalised(fixed<formats::depth> w) {
  constexpr int top = formats::w_mantissa::width - 1;
  const int power = leading_bit(w);
  if (power <= top) return {from_raw<formats::w_mantissa>(raw(w) * (std::int64_t(1) << (top - power))), power};
  const std::int64_t rounded = (raw(w) + (std::int64_t(1) << (power - top - 1))) >> (power - top);
  const bool carried = rounded >> (top + 1) != 0;
  return {from_raw<formats::w_mantissa>(carried ? std::int64_t(1) << top : rounded), power + (carried ? 1 : 0)};
}

struct attribute_times_c {
  fixed<formats::inverse_w> c;
  template <class To, class From>
  void operator()(fixed<To>& out, fixed<From> const& in) const {
    out = round_to<To>(in * c);
  }
};

}  // namespace detail

inline block_power block_exponent(fixed<formats::depth> w_0, fixed<formats::depth> w_1) {
  return from_raw<block_power::format_type>(detail::leading_bit(w_0 < w_1 ? w_0 : w_1));
}
inline block_power block_exponent(fixed<formats::depth> w_0, fixed<formats::depth> w_1, fixed<formats::depth> w_2) {
  return block_exponent(w_0 < w_1 ? w_0 : w_1, w_2);
}

inline interpolants perspective_preparation(perspective_preparation_in const& in) {
  const detail::normalised_w s0_w = detail::normalised(in.w);
  // c = 2^-(below + 1) / mantissa. The smallest numerator is that of w = 2^28, in a block of 2^0.
  using numerator = format<30, 1, false>;
  const int difference = s0_w.power - static_cast<int>(raw(in.exponent)), below = difference < 0 ? 0 : difference;
  bool clipped = false;
  const auto s1_c =
      divide<formats::inverse_w>(from_raw<numerator>(std::int64_t(1) << (numerator::fraction - 1 - below)), s0_w.mantissa, clipped);
  interpolants out;
  for_attributes(detail::attribute_times_c{s1_c}, out, in.vertex);
  out.c = exact_to<formats::interp_c>(s1_c);
  return out;
}

}  // namespace hls
}  // namespace relievo
