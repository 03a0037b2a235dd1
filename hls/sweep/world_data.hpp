// world_data: the records of the units between the world and the grid.          Gumhold & Huettner 1999, 3.1, 3.3, Figures 5, 8 and 9
//   near_clip -> transform (surface) -> base_triangle_clip -> grid_transform; z_table builds what grid_transform reads
//
//   grid_transform      in   screen, w of transform, w > 0;  regs cells_per_pixel 1/g, octave kappa ln 2, near_cells z of `near`
//                       out  p on the grid, saturated: a component beyond [-32767, 32767]
//   z_table             in   kappa and i, 0..256;  out  z, kappa ln(1 + i/256)
//   near_clip           in   vertex[3];  regs rows of transform (w_min takes no part), near, far; guard: the planes of the guard band too
//                       out  vertex[0..count-1], the polygon, what is beyond is all 0;  inside: the three words as they came
//                            empty: count is 0;  overflow: a plane made a tenth vertex, which was left out
//   base_triangle_clip  in   screen[corner], w[corner], d_max;  regs viewport W, H in pixels, reach of x and y, near, far, d_scale
//                       out  rejected
//   d_max_of            in   low, high: the box of the coordinates that are sampled, low <= high, u and v;  out  d_max
#pragma once
#include "hls/surface/transform.hpp"
#include "hls/sweep/vertex_data.hpp"

namespace relievo {
namespace hls {

struct grid_transform_in {
  fixed<formats::screen> screen[2];
  fixed<formats::depth> w;
  RELIEVO_FIELDS(screen, w)
};
struct grid_transform_regs {
  fixed<formats::cells> cells_per_pixel;
  fixed<formats::depth_cells> octave;
  fixed<formats::depth_cells> near_cells;
  RELIEVO_FIELDS(cells_per_pixel, octave, near_cells)
};
struct grid_transform_out {
  fixed<formats::grid> p[3];
  bool saturated;
  RELIEVO_FIELDS(p, saturated)
};

constexpr int z_table_words = 257;
// z_table_words words of depth_cells.
struct z_memory {
  std::int64_t const* words;
};

struct z_table_in {
  fixed<formats::kappa> kappa;
  fixed<format<9, 9, false>> i;
  RELIEVO_FIELDS(kappa, i)
};
struct z_table_out {
  fixed<formats::depth_cells> z;
  RELIEVO_FIELDS(z)
};

constexpr int clipped_vertices_max = 9;

struct near_clip_in {
  base_vertex vertex[3];
  RELIEVO_FIELDS(vertex)
};
struct near_clip_regs {
  transform_regs transform;
  fixed<formats::depth> near;
  fixed<formats::depth> far;
  bool guard;
  RELIEVO_FIELDS(transform, near, far, guard)
};
struct near_clip_out {
  base_vertex vertex[clipped_vertices_max];
  fixed<format<4, 4, false>> count;
  bool inside;
  bool empty;
  bool overflow;
  RELIEVO_FIELDS(vertex, count, inside, empty, overflow)
};

struct base_triangle_clip_in {
  fixed<formats::screen> screen[3][2];
  fixed<formats::depth> w[3];
  fixed<formats::extent> d_max;
  RELIEVO_FIELDS(screen, w, d_max)
};
struct base_triangle_clip_regs {
  fixed<formats::screen> viewport[2];
  fixed<formats::reach> reach[2];
  fixed<formats::depth> near;
  fixed<formats::depth> far;
  fixed<formats::matrix_w> d_scale;
  RELIEVO_FIELDS(viewport, reach, near, far, d_scale)
};
struct base_triangle_clip_out {
  bool rejected;
  RELIEVO_FIELDS(rejected)
};

struct d_max_of_in {
  fixed<formats::coordinate> low[2];
  fixed<formats::coordinate> high[2];
  RELIEVO_FIELDS(low, high)
};
struct d_max_of_out {
  fixed<formats::extent> d_max;
  RELIEVO_FIELDS(d_max)
};

}  // namespace hls
}  // namespace relievo
