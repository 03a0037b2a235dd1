// sub_triangle_remeshing: all primitives of one sub-triangle, strip by strip.             Gumhold & Huettner 1999, section 3.4.4
//   vertex i of an edge = P_from + i (P_to - P_from) / n;  row, column = floor(x + 1/2) of its exact t' and s'
//
//   in   p[3]    grid;  plane   remeshing_plane's output;  sub   one of case_selection's, not valid: no primitive
//   out  the primitives, in order
//
// The column of a side vertex is at most k1-1, so that none is left over on the line, the very last vertex excepted: it is at k1.
// An edge without steps still has two ends, which are two vertices.
#pragma once
#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "golden/sweep/case_selection.hpp"
#include "golden/sweep/main_direction.hpp"
#include "golden/sweep/remeshed.hpp"
#include "golden/sweep/remeshing_plane.hpp"
#include "golden/sweep/side_walk.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct sub_triangle_remeshing_in {
  glm::dvec3 p[3] = {};
  remeshing_plane_out plane;
  sub_triangle sub;
  RELIEVO_FIELDS(p, plane, sub)
};

// The vertices of the edge between two corners, in that direction, ends included.
inline std::vector<remeshed_vertex> edge_vertices(glm::dvec3 const (&p)[3], int from, int to) {
  const main_direction_out main = main_direction({{p[from], p[to]}});
  const int edge = (from + 1) % 3 == to ? from : to;
  const bool canonical = p[from][main.axis] <= p[to][main.axis];
  std::vector<remeshed_vertex> list;
  list.push_back({kind_corner, from, 0, 0, 0});
  for (double i = 1; i < main.n; ++i) list.push_back({kind_edge, edge, canonical ? i : main.n - i, 0, 0});
  list.push_back({kind_corner, to, 0, 0, 0});
  return list;
}

// The same with the grid points where they are in the frame.
inline std::vector<place> edge_places(sub_triangle_remeshing_in const& in, sweep_frame const& frame, int from, int to) {
  const std::vector<remeshed_vertex> vertices = edge_vertices(in.p, from, to);
  const grid_vector start(in.p[from]), delta = grid_vector(in.p[to]) - start;
  const auto n = static_cast<std::int64_t>(vertices.size()) - 1;
  const auto rounded_at = [&](int axis, std::int64_t sign, std::int64_t i) {
    return nearest(sign * (start[axis] * n + i * delta[axis]), n);
  };
  std::vector<place> list;
  for (remeshed_vertex const& v : vertices) {
    const auto i = static_cast<std::int64_t>(list.size());
    list.push_back({v, rounded_at(in.plane.s, frame.sign_s, i), rounded_at(in.plane.t, frame.sign_t, i), false});
  }
  return list;
}

inline sweep_frame frame_of(remeshing_plane_out const& plane, bool backward) {
  const bool odd = (plane.a + 1) % 3 != plane.b;
  return {backward ? -1 : 1, plane.mirrored ? -1 : 1, backward != odd};
}

inline std::vector<primitive> sub_triangle_remeshing(sub_triangle_remeshing_in const& in) {
  std::vector<primitive> out;
  sub_triangle const& sub = in.sub;
  if (!sub.valid) return out;
  const sweep_frame frame = frame_of(in.plane, sub.backward);
  const int start = sub.backward ? in.plane.b : in.plane.a, end = sub.backward ? in.plane.a : in.plane.b;
  const auto k0 = static_cast<std::int64_t>(sub.k0), k1 = static_cast<std::int64_t>(sub.k1);

  const std::vector<place> primary = edge_places(in, frame, start, end);
  const auto foot = [&](std::int64_t k) { return primary[static_cast<std::size_t>(k - primary.front().column)]; };

  std::vector<place> side = edge_places(in, frame, sub.from, sub.to);
  for (place& p : side) p.on_last_edge = true;
  if (sub.corner_list) {
    const std::vector<place> vertical = edge_places(in, frame, start, sub.from);
    side.insert(side.begin(), vertical.begin(), vertical.end() - 1);
  }
  for (place& p : side) p.column = std::min(p.column, k1 - 1);
  side.back().column = k1;
  std::vector<place> end_edge;
  if (sub.ends_on_edge) end_edge = edge_places(in, frame, sub.end_corner, sub.to);

  std::size_t at = sub.starts_at_corner ? 1 : 0;
  for (std::int64_t k = k0; k < k1; ++k) {
    const bool first = k == k0, last = k + 1 == k1;
    at = side_walk(frame, {k, foot(k), foot(k + 1), first && sub.starts_at_corner, last && sub.pointed, last && sub.ends_on_edge, at}, side,
                   end_edge, out);
  }
  return out;
}

}  // namespace golden
}  // namespace relievo
