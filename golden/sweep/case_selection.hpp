// case_selection: the one or two sub-triangles that a triangle is swept as.            Gumhold & Huettner 1999, section 3.4.3
//
//   The line s = C.s cuts the triangle at the side vertex C. Each part is swept so that its side edge rises in t':
//     roof         C.t' >= A.t' and C.t' >= B.t'   A -> C, and B -> C backward (s' = -s); both end on the line
//     increasing   A.t' <= C.t' < B.t'             A -> C to the line, and from the line C -> B, pointed at B
//     decreasing   C.t' < A.t'                     A and B exchanged, s' = -s, then as increasing
//
//   in   p[3]     grid;  plane   remeshing_plane's output
//   out  kind     0 point (all corners equal), 1 roof, 2 increasing, 3 decreasing
//        sub[2]   in the order of the sweep. One without width is not valid, and all its other fields are 0 then.
//     backward           s' = -s
//     k0, k1             grid   first and last column, in s'
//     from, to           corners: the side edge, in the direction of the walk
//     starts_at_corner   the walk begins at a corner of the primary edge, not on the interior line
//     pointed            it ends at the corner `to`, an end of the primary edge
//     corner_list        the second part when A.s = C.s (A after the exchange): there is no line, and the list of side vertices
//                        begins with the vertical edge from the start corner (a, backward b) to `from`
//     ends_on_edge       C.s is that of the end corner: it ends on a vertical side edge and not on the line
//     end_corner         the corner of the primary edge where that edge begins; 0 without ends_on_edge
#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "golden/sweep/remeshed.hpp"
#include "golden/sweep/remeshing_plane.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

enum case_kind { case_point = 0, case_roof = 1, case_increasing = 2, case_decreasing = 3 };

struct sub_triangle {
  bool valid = false;
  bool backward = false;
  double k0 = 0, k1 = 0;
  int from = 0, to = 0;
  bool starts_at_corner = false, pointed = false, corner_list = false, ends_on_edge = false;
  int end_corner = 0;
  RELIEVO_FIELDS(valid, backward, k0, k1, from, to, starts_at_corner, pointed, corner_list, ends_on_edge, end_corner)
};
struct case_selection_in {
  glm::dvec3 p[3] = {};
  remeshing_plane_out plane;
  RELIEVO_FIELDS(p, plane)
};
struct case_selection_out {
  int kind = 0;
  sub_triangle sub[2];
  RELIEVO_FIELDS(kind, sub)
};

namespace detail {

struct primary_ends {
  int start, end;
};

// From the start corner up to C; `end` is the other end of the primary edge.
inline sub_triangle rising_to_c(case_selection_in const& in, primary_ends e, bool backward) {
  const double sign = backward ? -1 : 1, k0 = sign * in.p[e.start][in.plane.s], k1 = sign * in.p[in.plane.c][in.plane.s];
  sub_triangle sub;
  if (k0 == k1) return sub;
  sub.valid = true;
  sub.backward = backward;
  sub.k0 = k0;
  sub.k1 = k1;
  sub.from = e.start;
  sub.to = in.plane.c;
  sub.starts_at_corner = true;
  sub.ends_on_edge = in.p[e.end][in.plane.s] == in.p[in.plane.c][in.plane.s];
  if (sub.ends_on_edge) sub.end_corner = e.end;
  return sub;
}

// From C up to the end corner.
inline sub_triangle pointed_from_c(case_selection_in const& in, primary_ends e, bool backward) {
  const double sign = backward ? -1 : 1, k0 = sign * in.p[in.plane.c][in.plane.s], k1 = sign * in.p[e.end][in.plane.s];
  sub_triangle sub;
  if (k0 == k1) return sub;
  sub.valid = true;
  sub.backward = backward;
  sub.k0 = k0;
  sub.k1 = k1;
  sub.from = in.plane.c;
  sub.to = e.end;
  sub.corner_list = in.p[e.start][in.plane.s] == in.p[in.plane.c][in.plane.s];
  sub.starts_at_corner = sub.corner_list;
  sub.pointed = true;
  return sub;
}

}  // namespace detail

inline case_selection_out case_selection(case_selection_in const& in) {
  case_selection_out out;
  if (in.p[0] == in.p[1] && in.p[1] == in.p[2]) return out;
  const double tau = in.plane.mirrored ? -1 : 1;
  const auto height = [&](int corner) { return tau * in.p[corner][in.plane.t]; };
  const double a = height(in.plane.a), b = height(in.plane.b), c = height(in.plane.c);
  const detail::primary_ends ab{in.plane.a, in.plane.b}, ba{in.plane.b, in.plane.a};
  if (c >= a && c >= b) {
    out.kind = case_roof;
    out.sub[0] = detail::rising_to_c(in, ab, false);
    out.sub[1] = detail::rising_to_c(in, ba, true);
  } else {
    const bool backward = c < a;
    out.kind = backward ? case_decreasing : case_increasing;
    out.sub[0] = detail::rising_to_c(in, backward ? ba : ab, backward);
    out.sub[1] = detail::pointed_from_c(in, backward ? ba : ab, backward);
  }
  return out;
}

}  // namespace golden
}  // namespace relievo
