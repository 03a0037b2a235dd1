// case_selection: the two sub-triangles of a triangle, one after the other, each walked so that its side edge climbs.
//   Gumhold & Huettner 1999, 3.4.3, Figure 13; zero widths, the vertical side edge and ties are ours
//   tAC = C.t' - A.t', tCB = B.t' - C.t'
//   kind  0 point       all corners equal: no sub-triangle
//         1 roof        tAC >= 0 and tCB <= 0: A -> C, then B -> C with s' = -s
//         2 increasing  tAC >= 0 and tCB > 0: A -> C, then on from the line s = C.s to B
//         3 decreasing  else: as increasing with A and B exchanged and s' = -s
//   in    p      grid[3][3];  plane  from remeshing_plane
//   out   kind, sub[2]; a sub-triangle of no width is not valid, and all its fields are 0
//   sub   valid
//         backward          s' = -s
//         k0, k1            first and last column, in s'
//         from, to          corners: the side edge that is walked, in the direction of the walk
//         starts_at_corner  the walk begins in the corner of the primary edge, not on the line s = C.s
//         pointed           the walk ends in `to`, which is a corner of the primary edge
//         corner_list       the first side edge is vertical: the walk begins with it, from that corner of the primary edge to `from`
//         ends_on_edge      the walk ends on a vertical side edge, not on the line
//         end_corner        the corner of the primary edge at which that vertical edge begins; 0 without one
//   exact: differences and comparisons; initiation interval 1
#pragma once
#include "hls/sweep/remeshing_plane.hpp"

namespace relievo {
namespace hls {

enum triangle_case { point_case, roof_case, increasing_case, decreasing_case };

struct case_selection_in {
  fixed<formats::grid> p[3][3];
  remeshing_plane_out plane;
  RELIEVO_FIELDS(p, plane)
};
struct sub_triangle {
  bool valid;
  bool backward;
  fixed<formats::grid> k0, k1;
  two_bits from, to;
  bool starts_at_corner;
  bool pointed;
  bool corner_list;
  bool ends_on_edge;
  two_bits end_corner;
  RELIEVO_FIELDS(valid, backward, k0, k1, from, to, starts_at_corner, pointed, corner_list, ends_on_edge, end_corner)
};
struct case_selection_out {
  two_bits kind;
  sub_triangle sub[2];
  RELIEVO_FIELDS(kind, sub)
};

namespace detail {
// A position along s'. -32768 has no mirror image; it is no position.
inline fixed<formats::grid> along(fixed<formats::grid> s, bool backward) { return backward ? wrap_to<formats::grid>(-s) : s; }
}  // namespace detail

inline case_selection_out case_selection(case_selection_in const& in) {
  using detail::along;
  case_selection_out out = case_selection_out();
  const int s = detail::of(in.plane.s), t = detail::of(in.plane.t);
  bool same = true;
  for (int axis = 0; axis < 3; ++axis) same = same && in.p[0][axis] == in.p[1][axis] && in.p[0][axis] == in.p[2][axis];
  if (same) return out;

  auto const &p_a = in.p[detail::of(in.plane.a)], &p_b = in.p[detail::of(in.plane.b)], &p_c = in.p[detail::of(in.plane.c)];
  const bool a_below_c = in.plane.mirrored ? p_a[t] >= p_c[t] : p_a[t] <= p_c[t];
  const bool c_below_b = in.plane.mirrored ? p_c[t] > p_b[t] : p_c[t] < p_b[t];
  sub_triangle &first = out.sub[0], &second = out.sub[1];
  if (a_below_c && !c_below_b) {
    out.kind = detail::two(roof_case);
    for (int i = 0; i < 2; ++i) {
      const bool backward = i == 1;
      auto const &begin = backward ? p_b : p_a, &end = backward ? p_a : p_b;
      if (begin[s] == p_c[s]) continue;
      sub_triangle& sub = out.sub[i];
      sub.valid = true;
      sub.backward = backward;
      sub.k0 = along(begin[s], backward);
      sub.k1 = along(p_c[s], backward);
      sub.from = backward ? in.plane.b : in.plane.a;
      sub.to = in.plane.c;
      sub.starts_at_corner = true;
      sub.ends_on_edge = end[s] == p_c[s];
      if (sub.ends_on_edge) sub.end_corner = backward ? in.plane.a : in.plane.b;
    }
    return out;
  }

  const bool backward = !a_below_c;
  out.kind = detail::two(backward ? decreasing_case : increasing_case);
  auto const &begin = backward ? p_b : p_a, &end = backward ? p_a : p_b;
  const bool vertical = begin[s] == p_c[s];
  if (!vertical) {
    first.valid = true;
    first.backward = backward;
    first.k0 = along(begin[s], backward);
    first.k1 = along(p_c[s], backward);
    first.from = backward ? in.plane.b : in.plane.a;
    first.to = in.plane.c;
    first.starts_at_corner = true;
  }
  // C lies above AB, so it stands below `end` only where it is not at its s.
  second.valid = true;
  second.backward = backward;
  second.k0 = along(p_c[s], backward);
  second.k1 = along(end[s], backward);
  second.from = in.plane.c;
  second.to = backward ? in.plane.a : in.plane.b;
  second.starts_at_corner = vertical;
  second.pointed = true;
  second.corner_list = vertical;
  return out;
}

}  // namespace hls
}  // namespace relievo
