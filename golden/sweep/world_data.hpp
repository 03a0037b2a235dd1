// world_data: the records of the units between the world and the grid.          Gumhold & Huettner 1999, sections 3.1 and 3.3
//
//   grid_transform      in   screen screen, w depth, > 0
//                       regs cells_per_pixel cells; octave, near_cells depth_cells
//                       out  p grid, saturated
//   z_table             in   kappa kappa, i 0..256;  out  z depth_cells
//   near_clip           in   vertex[3] base_vertex;  regs transform, near and far depth, guard
//                       out  vertex[9], count of them, the rest all 0; inside, empty, overflow
//   base_triangle_clip  in   screen[3] screen, w[3] depth, d_max extent
//                       regs viewport screen, reach reach, near and far depth, d_scale matrix_w, >= 0
//                       out  rejected
//   d_max_of            in   low, high coordinate;  out  d_max extent
#pragma once
#include <glm/glm.hpp>

#include "golden/surface/transform.hpp"
#include "golden/sweep/vertex_data.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct grid_transform_in {
  glm::dvec2 screen{0};
  double w = 1;
  RELIEVO_FIELDS(screen, w)
};
struct grid_transform_regs {
  double cells_per_pixel = 1;
  double octave = 0;
  double near_cells = 0;
  RELIEVO_FIELDS(cells_per_pixel, octave, near_cells)
};
struct grid_transform_out {
  glm::dvec3 p{0};
  bool saturated = false;
  RELIEVO_FIELDS(p, saturated)
};

constexpr int z_table_words = 257;

struct z_table_in {
  double kappa = 0;
  int i = 0;
  RELIEVO_FIELDS(kappa, i)
};
struct z_table_out {
  double z = 0;
  RELIEVO_FIELDS(z)
};

constexpr int clipped_vertices_max = 9;

struct near_clip_in {
  base_vertex vertex[3];
  RELIEVO_FIELDS(vertex)
};
struct near_clip_regs {
  transform_regs transform;
  double near = 0;
  double far = 0;
  bool guard = false;
  RELIEVO_FIELDS(transform, near, far, guard)
};
struct near_clip_out {
  base_vertex vertex[clipped_vertices_max];
  int count = 0;
  bool inside = false;
  bool empty = false;
  bool overflow = false;
  RELIEVO_FIELDS(vertex, count, inside, empty, overflow)
};

struct base_triangle_clip_in {
  glm::dvec2 screen[3] = {};
  double w[3] = {1, 1, 1};
  double d_max = 0;
  RELIEVO_FIELDS(screen, w, d_max)
};
struct base_triangle_clip_regs {
  glm::dvec2 viewport{0};
  glm::dvec2 reach{0};
  double near = 0;
  double far = 0;
  double d_scale = 0;
  RELIEVO_FIELDS(viewport, reach, near, far, d_scale)
};
struct base_triangle_clip_out {
  bool rejected = false;
  RELIEVO_FIELDS(rejected)
};

struct d_max_of_in {
  glm::dvec2 low{0}, high{0};
  RELIEVO_FIELDS(low, high)
};
struct d_max_of_out {
  double d_max = 0;
  RELIEVO_FIELDS(d_max)
};

}  // namespace golden
}  // namespace relievo
