// remeshing_plane: the coordinate plane in which a triangle is remeshed, and its corners by their part in the sweep.
//   s        sweep direction: the main direction of the primary edge AB; A is its end with the lower s
//   t        side direction: the other axis with the larger |det|, the earlier one on ties     Gumhold & Huettner 1999, 3.4.1, Figure 10
//   det      (B - A) x (C - A) in (s, t), twice the area of the projection; 0 exactly where the corners lie on one line in space
//   mirrored t' = -t where det < 0, else t: in (s, t') the side vertex C lies above AB
//   in    p     grid[3][3];  edge, axis  the primary edge and its main direction
//   out   s, t;  a, b, c  corners;  det  signed, 35 bits;  mirrored
//   exact; two products of 17 x 17 bits for each of the two planes; initiation interval 1
#pragma once
#include "hls/sweep/remeshed.hpp"

namespace relievo {
namespace hls {

struct remeshing_plane_in {
  fixed<formats::grid> p[3][3];
  two_bits edge;
  two_bits axis;
  RELIEVO_FIELDS(p, edge, axis)
};
struct remeshing_plane_out {
  two_bits s, t;
  two_bits a, b, c;
  fixed<format<35, 35, true>> det;
  bool mirrored;
  RELIEVO_FIELDS(s, t, a, b, c, det, mirrored)
};

inline remeshing_plane_out remeshing_plane(remeshing_plane_in const& in) {
  const int s = detail::of(in.axis);
  const int first = detail::of(in.edge), second = detail::after(first), c = detail::after(second);
  const bool rising = in.p[first][s] <= in.p[second][s];
  const int a = rising ? first : second, b = rising ? second : first;
  const auto determinant = [&](int t) {
    return (in.p[b][s] - in.p[a][s]) * (in.p[c][t] - in.p[a][t]) - (in.p[b][t] - in.p[a][t]) * (in.p[c][s] - in.p[a][s]);
  };
  const int earlier = s == 0 ? 1 : 0, later = s == 2 ? 1 : 2;
  const auto det_earlier = determinant(earlier), det_later = determinant(later);
  const bool take_later = magnitude(det_later) > magnitude(det_earlier);
  remeshing_plane_out out;
  out.s = in.axis;
  out.t = detail::two(take_later ? later : earlier);
  out.a = detail::two(a);
  out.b = detail::two(b);
  out.c = detail::two(c);
  out.det = take_later ? det_later : det_earlier;
  out.mirrored = out.det < from_raw<format<1, 1, false>>(0);
  return out;
}

}  // namespace hls
}  // namespace relievo
