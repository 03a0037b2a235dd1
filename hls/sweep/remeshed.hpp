// remeshed: what the remeshing of a triangle puts out, by name: no vertex data, which follows from the names.
//   Gumhold & Huettner 1999, 3.4.4
//   remeshed_vertex  kind    0 corner of the base triangle, 1 vertex of an edge, 2 grid vertex
//                    number  corner or edge, edge i joins corners i and (i+1) mod 3; 0 for a grid vertex
//                    i       kind 1: place on the edge, 1..n-1, from its canonical end, the one with the lower main coordinate; else 0
//                    s, t    kind 2: position in the remeshing plane, in the axes as they are, not mirrored and not swapped; else 0
//   primitive        quad    v[0..3], its triangles are (v0, v1, v3) and (v1, v2, v3); a triangle is v[0..2], and v[3] is all 0
//   The triangles of a primitive turn in the remeshing plane as the base triangle (p0, p1, p2) does.
#pragma once
#include "hls/core/fixed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace hls {

// An axis (0 x, 1 y, 2 z), a corner, an edge, a kind.
using two_bits = fixed<format<2, 2, false>>;

struct remeshed_vertex {
  two_bits kind;
  two_bits number;
  fixed<formats::steps> i;
  fixed<formats::grid> s, t;
  RELIEVO_FIELDS(kind, number, i, s, t)
};
struct primitive {
  bool quad;
  remeshed_vertex v[4];
  RELIEVO_FIELDS(quad, v)
};

enum vertex_kind { corner_vertex, edge_vertex, grid_vertex };

namespace detail {
inline two_bits two(int word) { return from_raw<two_bits::format_type>(word); }
inline int of(two_bits word) { return static_cast<int>(raw(word)); }
inline int of(fixed<formats::grid> word) { return static_cast<int>(raw(word)); }
// The corner, or the edge, after this one.
inline int after(int corner) { return corner == 2 ? 0 : corner + 1; }
// The edge that joins two corners.
inline int edge_of(int from, int to) { return after(from) == to ? from : to; }
}  // namespace detail

}  // namespace hls
}  // namespace relievo
