// primary_edge: the edge that the sweep follows.                     Gumhold & Huettner 1999, definition 2, theorem 1, section 3.4.1
//   Edge p1 p2 with main direction s is primary when min(p1.s, p2.s) <= p3.s <= max(p1.s, p2.s).
//   Of the primary edges the one with most steps is taken, the first of them on ties. Theorem 1: there is one.
//
//   in   p[3]      grid    the corners
//        axis[3]           main direction of edge i, which joins p[i] and p[(i+1)%3]
//        n[3]      steps   its steps
//   out  edge              0..2
//
// Error: std::logic_error where there is none, which only an axis or n that is not main_direction's can cause.
#pragma once
#include <algorithm>
#include <glm/glm.hpp>
#include <stdexcept>

#include "golden/sweep/remeshed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct primary_edge_in {
  glm::dvec3 p[3] = {};
  int axis[3] = {0, 0, 0};
  double n[3] = {0, 0, 0};
  RELIEVO_FIELDS(p, axis, n)
};
struct primary_edge_out {
  int edge = 0;
  RELIEVO_FIELDS(edge)
};

// Definition 2 for edge i.
inline bool is_primary(primary_edge_in const& in, int i) {
  const int s = in.axis[i];
  const double p1 = in.p[i][s], p2 = in.p[(i + 1) % 3][s], p3 = in.p[(i + 2) % 3][s];
  return std::min(p1, p2) <= p3 && p3 <= std::max(p1, p2);
}

inline primary_edge_out primary_edge(primary_edge_in const& in) {
  int longest = -1;
  for (int i = 0; i < 3; ++i)
    if (is_primary(in, i) && (longest < 0 || in.n[i] > in.n[longest])) longest = i;
  if (longest < 0) throw std::logic_error("primary_edge: axis and n are not those of the corners");
  return {longest};
}

}  // namespace golden
}  // namespace relievo
