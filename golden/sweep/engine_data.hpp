// engine_data: what goes into the sweep engine, what comes out, its registers and what it counts.   Gumhold & Huettner 1999, Figures 3 and
// 5
//
//   base_triangle    v[3] base_vertex;  index of the base triangle;  last of the mesh
//   swept_vertex     p, n, t, u, colour   on the base surface;  displaced_p position, displaced_n unit   P' and N'
//                    screen screen, w depth, behind   P'_s, as transform gives it
//   swept_triangle   v[3], index;  empty: no triangle, carries `last` alone when nothing at all was put out;  last
//   sweep_regs       constant while a mesh runs; already quantised to their formats for every model, the ideal one too
//     map, displace, transform
//     near, far depth;  guard: the guard band clips too;  viewport screen   W, H
//     reach, d_scale, d_max   base_triangle_clip's; d_max extent   holds for the whole map
//     kappa kappa, for z_table;  grid   grid_transform's;  limit coordinate   perspective_correction's
//   sweep_counters   none depends on time
//     triangles_in;  cut: in part beyond a plane of near_clip, outside: wholly so;  overflows: near_clip had no room for a vertex
//     pieces: triangles after near_clip, of a triangle that was not cut one;  rejected: of them, by base_triangle_clip
//     primitives, quads among them;  vertices: computed, those that a primitive shares with the one before are not again
//     triangles_out;  unseen: displaced triangles that view_volume_clip left out
//     saturations: perspective_correction, displace, bump of a vertex;  screen_saturations: transform of a corner or a displaced vertex;
//     grid_saturations: of a corner;  zero_vectors: bump
//   swept_piece      what an observer of golden sees of a piece: its corners, and where it is walked their places on the grid and the plane
//
// name and piece are no fields of the hardware's records: the names of the triangle's vertices, and the number of its piece.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "golden/surface/displace.hpp"
#include "golden/surface/map_regs.hpp"
#include "golden/surface/transform.hpp"
#include "golden/sweep/remeshed.hpp"
#include "golden/sweep/remeshing_plane.hpp"
#include "golden/sweep/vertex_data.hpp"
#include "golden/sweep/world_data.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct base_triangle {
  base_vertex v[3];
  double index = 0;
  bool last = false;
  RELIEVO_FIELDS(v, index, last)
};

struct swept_vertex {
  glm::dvec3 p{0}, n{0}, t{0};
  glm::dvec2 u{0};
  glm::dvec4 colour{0};
  glm::dvec3 displaced_p{0}, displaced_n{0};
  glm::dvec2 screen{0};
  double w = 0;
  bool behind = false;
  RELIEVO_FIELDS(p, n, t, u, colour, displaced_p, displaced_n, screen, w, behind)
};

struct swept_triangle {
  swept_vertex v[3];
  double index = 0;
  bool empty = false;
  bool last = false;
  RELIEVO_FIELDS(v, index, empty, last)

  remeshed_vertex name[3];
  std::uint64_t piece = 0;
};

struct swept_piece {
  base_vertex v[3];
  double index = 0;     // of the base triangle
  bool walked = false;  // not rejected
  glm::dvec3 p[3] = {};
  remeshing_plane_out plane;
};

struct sweep_regs {
  map_regs map;
  displace_regs displace;
  transform_regs transform;
  double near = 0, far = 0;
  bool guard = true;
  glm::dvec2 viewport{0};
  glm::dvec2 reach{0};
  double d_scale = 0;
  double d_max = 0;
  double kappa = 0;
  grid_transform_regs grid;
  glm::dvec2 limit{0};
  RELIEVO_FIELDS(map, displace, transform, near, far, guard, viewport, reach, d_scale, d_max, kappa, grid, limit)
};

struct sweep_counters {
  std::uint64_t triangles_in = 0, cut = 0, outside = 0, overflows = 0;
  std::uint64_t pieces = 0, rejected = 0;
  std::uint64_t primitives = 0, quads = 0, vertices = 0;
  std::uint64_t triangles_out = 0, unseen = 0;
  std::uint64_t saturations = 0, screen_saturations = 0, grid_saturations = 0, zero_vectors = 0;
  RELIEVO_FIELDS(triangles_in, cut, outside, overflows, pieces, rejected, primitives, quads, vertices, triangles_out, unseen, saturations,
                 screen_saturations, grid_saturations, zero_vectors)
};

}  // namespace golden
}  // namespace relievo
