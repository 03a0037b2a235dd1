// calculate_new_p: the point at k/16 of an edge; k = 8 is the paper's midpoint.
//   P12 = (P1 (16 - k) + P2 k) / 16                           Doggett & Hirche 2000, 2.1 and section 3, Calculate New P
//   in    p1, p2  position[3];  k  weight, 0..16
//   out   p       position[3], rounded once; exchanging the ends and taking 16 - k gives the same bits
//   initiation interval 1
#pragma once
#include "hls/core/fixed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace hls {

struct calculate_new_p_in {
  fixed<formats::position> p1[3];
  fixed<formats::position> p2[3];
  fixed<formats::weight> k;
  RELIEVO_FIELDS(p1, p2, k)
};
struct calculate_new_p_out {
  fixed<formats::position> p[3];
  RELIEVO_FIELDS(p)
};

namespace detail {
// a (16 - k) + b k, exact: sixteen times the point between.
template <class F>
inline auto weighted_sum(fixed<F> a, fixed<F> b, fixed<formats::weight> k) {
  return a * wrap_to<formats::weight>(from_raw<formats::weight>(16) - k) + b * k;
}
}  // namespace detail

inline calculate_new_p_out calculate_new_p(calculate_new_p_in const& in) {
  calculate_new_p_out out;
  for (int i = 0; i < 3; ++i) out.p[i] = round_to<formats::position>(times_two_to<-4>(detail::weighted_sum(in.p1[i], in.p2[i], in.k)));
  return out;
}

}  // namespace hls
}  // namespace relievo
