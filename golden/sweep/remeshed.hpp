// remeshed: what the sweep makes of one base triangle, by name and not yet by value.   Gumhold & Huettner 1999, section 3.4
//
//   remeshed_vertex   kind     0 corner, 1 on an edge, 2 on the grid
//                     number   corner or edge, 0..2; edge e joins the corners e and (e+1)%3; 0 on the grid
//                     i        steps   edge: place from the canonical end, the one with the lower main coordinate, 1..n-1; else 0
//                     s, t     grid    grid: the point of the remeshing plane, in the axes as they are; else 0
//   primitive         quad;  v[4]
//     The triangles of a quad are (v0, v1, v3) and (v1, v2, v3); those of a triangle v[0..2], its v[3] is all zero. They have the
//     orientation of the base triangle in the remeshing plane.
//
// A vertex is its name: corners that share a grid point are still two vertices, as they may differ in the world.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

enum remeshed_kind { kind_corner = 0, kind_edge = 1, kind_grid = 2 };

struct remeshed_vertex {
  int kind = 0, number = 0;
  double i = 0;
  double s = 0, t = 0;
  RELIEVO_FIELDS(kind, number, i, s, t)
};

struct primitive {
  bool quad = false;
  remeshed_vertex v[4];
  RELIEVO_FIELDS(quad, v)
};

// Words of the grid are integers; the combinatorics are done in these.
using grid_vector = glm::vec<3, std::int64_t>;

inline bool operator==(remeshed_vertex const& a, remeshed_vertex const& b) {
  return a.kind == b.kind && a.number == b.number && a.i == b.i && a.s == b.s && a.t == b.t;
}
inline bool operator!=(remeshed_vertex const& a, remeshed_vertex const& b) { return !(a == b); }

// floor(numerator / denominator + 1/2), exact; the denominator is positive.
inline std::int64_t nearest(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t n = 2 * numerator + denominator, d = 2 * denominator;
  return n / d - (n % d < 0 ? 1 : 0);
}

}  // namespace golden
}  // namespace relievo
