// calculate_new_u: the texture coordinate at k/16 of an edge; k = 8 is the paper's midpoint.
//   U12 = (U1 (16 - k) + U2 k) / 16                           Doggett & Hirche 2000, 2.1 and 3.1.2, Calculate New U
//   in    u1, u2  coordinate[2], texels;  k  weight, 0..16
//   out   u       coordinate[2], rounded once; exchanging the ends and taking 16 - k gives the same bits
//   initiation interval 1
#pragma once
#include "hls/edge/calculate_new_p.hpp"

namespace relievo {
namespace hls {

struct calculate_new_u_in {
  fixed<formats::coordinate> u1[2];
  fixed<formats::coordinate> u2[2];
  fixed<formats::weight> k;
  RELIEVO_FIELDS(u1, u2, k)
};
struct calculate_new_u_out {
  fixed<formats::coordinate> u[2];
  RELIEVO_FIELDS(u)
};

inline calculate_new_u_out calculate_new_u(calculate_new_u_in const& in) {
  calculate_new_u_out out;
  for (int i = 0; i < 2; ++i) out.u[i] = round_to<formats::coordinate>(times_two_to<-4>(detail::weighted_sum(in.u1[i], in.u2[i], in.k)));
  return out;
}

}  // namespace hls
}  // namespace relievo
