// calculate_new_n: the unit vector at k/16 of an edge, for normals and tangents.
//   N12 = normalize((N1 (16 - k) + N2 k) / 16)                Doggett & Hirche 2000, 2.1 and 3.1.4
//   in    n1, n2   unit[3];  k  weight, 0..16
//         tangent  opposite ends give (1,0,0), else (0,0,1)
//   out   n        unit[3];  zero  the ends cancelled
//   registers: s0_direction (direction) holds twice the mean, so the midpoint loses nothing; n (unit)
//   initiation interval 1
#pragma once
#include "hls/core/normalize.hpp"
#include "hls/edge/calculate_new_p.hpp"

namespace relievo {
namespace hls {

struct calculate_new_n_in {
  fixed<formats::unit> n1[3];
  fixed<formats::unit> n2[3];
  fixed<formats::weight> k;
  bool tangent;
  RELIEVO_FIELDS(n1, n2, k, tangent)
};
struct calculate_new_n_out {
  fixed<formats::unit> n[3];
  bool zero;
  RELIEVO_FIELDS(n, zero)
};

inline calculate_new_n_out calculate_new_n(calculate_new_n_in const& in) {
  normalize_in s0_direction;
  s0_direction.tangent = in.tangent;
  for (int i = 0; i < 3; ++i)
    s0_direction.v[i] = round_to<formats::direction>(times_two_to<-3>(detail::weighted_sum(in.n1[i], in.n2[i], in.k)));
  const normalize_out s1_unit = normalize(s0_direction);
  calculate_new_n_out out;
  for (int i = 0; i < 3; ++i) out.n[i] = s1_unit.n[i];
  out.zero = s1_unit.zero;
  return out;
}

}  // namespace hls
}  // namespace relievo
