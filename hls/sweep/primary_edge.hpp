// primary_edge: the edge along which the sweep line moves.
//   primary   edge p1 p2 with main direction s is primary when min(p1.s, p2.s) <= p3.s <= max(p1.s, p2.s)
//   edge      the longest of them by n, the first on ties                 Gumhold & Huettner 1999, definition 2, theorem 1, 3.4.1
//   in    p     grid[3][3]
//         axis, n  of each edge, from main_direction; edge i joins p[i] and p[(i+1) mod 3]
//   out   edge  by theorem 1 there is one; 0 where axis and n are not those of the corners and no edge is primary
//   exact; initiation interval 1
#pragma once
#include "hls/sweep/remeshed.hpp"

namespace relievo {
namespace hls {

struct primary_edge_in {
  fixed<formats::grid> p[3][3];
  two_bits axis[3];
  fixed<formats::steps> n[3];
  RELIEVO_FIELDS(p, axis, n)
};
struct primary_edge_out {
  two_bits edge;
  RELIEVO_FIELDS(edge)
};

inline bool is_primary(primary_edge_in const& in, int edge) {
  const int s = detail::of(in.axis[edge]), next = detail::after(edge);
  const auto p1 = in.p[edge][s], p2 = in.p[next][s], p3 = in.p[detail::after(next)][s];
  return p1 <= p2 ? p1 <= p3 && p3 <= p2 : p2 <= p3 && p3 <= p1;
}

inline primary_edge_out primary_edge(primary_edge_in const& in) {
  int edge = 0;
  bool found = false;
  for (int i = 0; i < 3; ++i)
    if (is_primary(in, i) && (!found || in.n[i] > in.n[edge])) {
      edge = i;
      found = true;
    }
  return {detail::two(edge)};
}

}  // namespace hls
}  // namespace relievo
