// sweep_words: what the set-up of a triangle hands from unit to unit, for tests of the circuits.
//   edges_word(p), plane_word(p), case_word(p)   inputs of primary_edge, remeshing_plane, case_selection of a triangle
//   draw_grid_triangle(g)                        small or large, anywhere or a sliver
#pragma once
#include "hls/sweep/sweep_line.hpp"
#include "tests/support/grid_triangles.hpp"
#include "tests/support/remeshed_mesh.hpp"

namespace relievo::test {

inline grid_triangle draw_grid_triangle(generator& g) {
  const int size = g.chance(2) ? 6 : 16383;
  return g.chance(2) ? draw_triangle(g, size) : draw_sliver(g, size);
}

inline hls::primary_edge_in edges_word(grid_triangle const& p) {
  const hls::sweep_line_in corners = corners_of(p);
  const hls::sweep_setup setup = hls::set_up(corners);
  hls::primary_edge_in in;
  for (int i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) in.p[i][axis] = corners.p[i][axis];
    in.axis[i] = setup.main[i].axis;
    in.n[i] = setup.main[i].n;
  }
  return in;
}

inline hls::remeshing_plane_in plane_word(grid_triangle const& p) {
  const hls::primary_edge_in edges = edges_word(p);
  hls::remeshing_plane_in in;
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) in.p[i][axis] = edges.p[i][axis];
  in.edge = hls::primary_edge(edges).edge;
  in.axis = edges.axis[raw(in.edge)];
  return in;
}

inline hls::case_selection_in case_word(grid_triangle const& p) {
  const hls::sweep_line_in corners = corners_of(p);
  hls::case_selection_in in;
  in.plane = hls::set_up(corners).plane;
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) in.p[i][axis] = corners.p[i][axis];
  return in;
}

}  // namespace relievo::test
