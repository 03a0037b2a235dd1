// engine_data: what goes into the sweep engine, what comes out, its registers and memories, and what it counts.
//   Gumhold & Huettner 1999, Figures 3 and 5
//   base_triangle    v three corners as given;  index of the base triangle;  last of the mesh
//   swept_vertex     P, N, T, U, colour on the base surface;  P', N';  P'_s, w and behind as transform gives them
//   swept_triangle   v in the orientation of the base triangle;  index;  empty carries `last` alone, when nothing at all was put out
//   sweep_regs       taken over at start, constant until the mesh has drained
//     near, far of near_clip and all later ones;  guard  near_clip's;  viewport W, H;  reach, d_scale, d_max  of base_triangle_clip
//     kappa  the z table is made of it;  grid  grid_transform's;  limit  perspective_correction's
//   sweep_counters   no count depends on time, so every model counts the same
//     triangles_in;  cut in part by near_clip, outside wholly;  overflows of near_clip
//     pieces  triangles after near_clip;  rejected  of them, by base_triangle_clip
//     primitives, quads of them;  vertices  computed: what a primitive shares with the one before is kept
//     triangles_out;  unseen  left out by view_volume_clip
//     saturations  a vertex that clipped in perspective_correction, displace or bump;  screen_saturations  a corner or a displaced
//     vertex in transform;  grid_saturations  a corner;  zero_vectors  bump
#pragma once
#include "hls/surface/displace.hpp"
#include "hls/surface/map_regs.hpp"
#include "hls/surface/transform.hpp"
#include "hls/sweep/remeshed.hpp"
#include "hls/sweep/vertex_data.hpp"
#include "hls/sweep/world_data.hpp"

namespace relievo {
namespace hls {

struct base_triangle {
  base_vertex v[3];
  fixed<formats::index> index;
  bool last;
  RELIEVO_FIELDS(v, index, last)
};

struct swept_vertex {
  fixed<formats::position> p[3];
  fixed<formats::unit> n[3];
  fixed<formats::unit> t[3];
  fixed<formats::coordinate> u[2];
  fixed<formats::colour> colour[4];
  fixed<formats::position> displaced_p[3];
  fixed<formats::unit> displaced_n[3];
  fixed<formats::screen> screen[2];
  fixed<formats::depth> w;
  bool behind;
  RELIEVO_FIELDS(p, n, t, u, colour, displaced_p, displaced_n, screen, w, behind)
};

struct swept_triangle {
  swept_vertex v[3];
  fixed<formats::index> index;
  bool empty;
  bool last;
  RELIEVO_FIELDS(v, index, empty, last)
};

struct sweep_regs {
  map_regs map;
  displace_regs displace;
  transform_regs transform;
  fixed<formats::depth> near;
  fixed<formats::depth> far;
  bool guard;
  fixed<formats::screen> viewport[2];
  fixed<formats::reach> reach[2];
  fixed<formats::matrix_w> d_scale;
  fixed<formats::extent> d_max;
  fixed<formats::kappa> kappa;
  grid_transform_regs grid;
  fixed<formats::coordinate> limit[2];
  RELIEVO_FIELDS(map, displace, transform, near, far, guard, viewport, reach, d_scale, d_max, kappa, grid, limit)
};

struct sweep_memories {
  texel_memory displacement;
  normal_memory normals;
  z_memory z;
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

}  // namespace hls
}  // namespace relievo
