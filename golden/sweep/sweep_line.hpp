// sweep_line: a base triangle becomes quads and triangles of the size of a grid cell.        Gumhold & Huettner 1999, section 3.4
//   main_direction of each edge -> primary_edge -> remeshing_plane -> case_selection -> sub_triangle_remeshing of each part
//
//   in   p[3]   grid   the corners, rounded to the grid
//   out  the primitives, in order
//
// All corners equal: one triangle of the corners 0, 1, 2.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "golden/sweep/case_selection.hpp"
#include "golden/sweep/main_direction.hpp"
#include "golden/sweep/primary_edge.hpp"
#include "golden/sweep/remeshed.hpp"
#include "golden/sweep/remeshing_plane.hpp"
#include "golden/sweep/sub_triangle_remeshing.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct sweep_line_in {
  glm::dvec3 p[3] = {};
  RELIEVO_FIELDS(p)
};

// The setup of a triangle: everything that is known before the first primitive.
struct sweep_setup {
  remeshing_plane_out plane;
  case_selection_out cases;
};

inline sweep_setup setup_of(sweep_line_in const& in) {
  primary_edge_in edges;
  for (int i = 0; i < 3; ++i) {
    const main_direction_out main = main_direction({{in.p[i], in.p[(i + 1) % 3]}});
    edges.p[i] = in.p[i];
    edges.axis[i] = main.axis;
    edges.n[i] = main.n;
  }
  const int edge = primary_edge(edges).edge;
  const remeshing_plane_out plane = remeshing_plane({{in.p[0], in.p[1], in.p[2]}, edge, edges.axis[edge]});
  return {plane, case_selection({{in.p[0], in.p[1], in.p[2]}, plane})};
}

inline std::vector<primitive> sweep_line(sweep_line_in const& in) {
  const sweep_setup setup = setup_of(in);
  std::vector<primitive> out;
  if (setup.cases.kind == case_point) {
    out.push_back({false, {{kind_corner, 0, 0, 0, 0}, {kind_corner, 1, 0, 0, 0}, {kind_corner, 2, 0, 0, 0}, {}}});
    return out;
  }
  for (sub_triangle const& sub : setup.cases.sub) {
    const std::vector<primitive> part = sub_triangle_remeshing({{in.p[0], in.p[1], in.p[2]}, setup.plane, sub});
    out.insert(out.end(), part.begin(), part.end());
  }
  return out;
}

}  // namespace golden
}  // namespace relievo
