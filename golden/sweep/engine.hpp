// engine: a displaced mesh, remeshed to cells of the screen's grid; each vertex computed from its name.   Gumhold & Huettner 1999
//   near_clip -> transform -> base_triangle_clip -> grid_transform -> sweep_line -> perspective_correction -> map_sampler -> displace,
//   bump -> transform -> view_volume_clip                                                                         Figures 3 and 5
//
//   sweep_engine<Rounding>(registers, memories).run(next, out, observer) -> sweep_counters
//     next(base_triangle&) -> bool    the next base triangle; false when there is none
//     out(swept_triangle const&)      a finished triangle; the last one carries `last`, an empty record does when there is none
//     observer(swept_piece const&)    every piece of a base triangle, before its triangles; `walked`: not rejected
//
// A base triangle that near_clip cuts becomes pieces, the fan of its polygon about its first vertex; any other is one piece. A corner
// of a piece has its given words. An edge's vertices depend on the edge's two ends alone, so neighbours have the same.
// Where a wrapped map closes, one triangle has U = W along an edge and its neighbour U = 0: its vertices have W itself, as W c / c would
// have an error that 0 c / c has not.
// The ideal walks the same grid as golden does: corners on whole cells are the algorithm's, not a rounding of its numbers.
// Displacement is sampled unfiltered, the colour passes through.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "golden/surface/bump.hpp"
#include "golden/surface/displace.hpp"
#include "golden/surface/map_sampler.hpp"
#include "golden/surface/memories.hpp"
#include "golden/surface/normal_sampler.hpp"
#include "golden/surface/transform.hpp"
#include "golden/sweep/base_triangle_clip.hpp"
#include "golden/sweep/difference_vertices.hpp"
#include "golden/sweep/engine_data.hpp"
#include "golden/sweep/grid_transform.hpp"
#include "golden/sweep/interpolated_vertex.hpp"
#include "golden/sweep/near_clip.hpp"
#include "golden/sweep/perspective_correction.hpp"
#include "golden/sweep/perspective_preparation.hpp"
#include "golden/sweep/sweep_line.hpp"
#include "golden/sweep/view_volume_clip.hpp"
#include "golden/sweep/z_table.hpp"

namespace relievo {
namespace golden {

template <class Rounding>
class sweep_engine {
 public:
  sweep_engine(sweep_regs const& regs, memories const& maps)
      : regs_(regs),
        texels_(maps.texels, regs.map),
        normals_(texels_, regs.map, maps.normal_map),
        z_table_(z_table_of<Rounding>(regs.kappa)) {}

  template <class Next, class Out, class Observer>
  sweep_counters run(Next&& next, Out&& out, Observer&& observer) {
    count_ = sweep_counters{};
    swept_triangle held;
    bool holding = false;
    const auto put = [&](swept_triangle const& t) {
      if (holding) out(held);
      held = t;
      holding = true;
    };
    for (base_triangle t; next(t);) {
      ++count_.triangles_in;
      const near_clip_out polygon = near_clip<Rounding>({{t.v[0], t.v[1], t.v[2]}}, {regs_.transform, regs_.near, regs_.far, regs_.guard});
      count_.cut += polygon.inside || polygon.empty ? 0 : 1;
      count_.outside += polygon.empty ? 1 : 0;
      count_.overflows += polygon.overflow ? 1 : 0;
      for (int k = 0; k + 2 < polygon.count; ++k) {
        piece_ = swept_piece{{polygon.vertex[0], polygon.vertex[k + 1], polygon.vertex[k + 2]}, t.index, false, {}, {}};
        sweep(observer, put);
        ++count_.pieces;
      }
    }
    held.empty = !holding;
    held.last = true;
    out(held);
    return count_;
  }
  template <class Next, class Out>
  sweep_counters run(Next&& next, Out&& out) {
    return run(next, out, [](swept_piece const&) {});
  }

 private:
  template <class Observer, class Put>
  void sweep(Observer&& observer, Put&& put) {
    double w[3];
    piece_.walked = place_on_grid(w);
    if (piece_.walked) piece_.plane = setup_of({{piece_.p[0], piece_.p[1], piece_.p[2]}}).plane;
    observer(piece_);
    if (!piece_.walked) {
      ++count_.rejected;
      return;
    }
    const prepared_triangle data = prepare_triangle<Rounding>(piece_.p, piece_.v, w);
    interpolated_.plane = piece_.plane;
    difference_vertices_in ends{{}, piece_.plane, {}, {}};
    for (int i = 0; i < 3; ++i) {
      interpolated_.p[i] = ends.p[i] = piece_.p[i];
      interpolated_.corner[i] = ends.corner[i] = data.corner[i];
      for (int k = 0; k < 2; ++k) interpolated_.end[i][k] = ends.end[i][k] = data.end[i][k];
    }
    interpolated_.difference = difference_vertices<Rounding>(ends);

    std::vector<named_vertex> before;
    for (primitive const& walked : sweep_line({{piece_.p[0], piece_.p[1], piece_.p[2]}})) {
      ++count_.primitives;
      count_.quads += walked.quad ? 1 : 0;
      std::vector<named_vertex> now;
      now.reserve(4);
      for (int i = 0; i < (walked.quad ? 4 : 3); ++i) now.push_back({walked.v[i], vertex_of(walked.v[i], before)});
      if (walked.quad) {
        put_seen(now[0], now[1], now[3], put);
        put_seen(now[1], now[2], now[3], put);
      } else {
        put_seen(now[0], now[1], now[2], put);
      }
      before = now;
    }
  }

  // Corners to screen and grid; whether the piece can be seen at all.
  bool place_on_grid(double (&w)[3]) {
    base_triangle_clip_in clip;
    clip.d_max = regs_.d_max;
    for (int i = 0; i < 3; ++i) {
      const transform_out seen = transform<Rounding>({piece_.v[i].p}, regs_.transform);
      count_.screen_saturations += seen.saturated ? 1 : 0;
      clip.screen[i] = seen.screen;
      clip.w[i] = w[i] = seen.w;
    }
    if (base_triangle_clip<Rounding>(clip, {regs_.viewport, regs_.reach, regs_.near, regs_.far, regs_.d_scale}).rejected) return false;
    for (int i = 0; i < 3; ++i) {
      const grid_transform_out place = grid_transform<Rounding>({clip.screen[i], w[i]}, regs_.grid, z_table_);
      count_.grid_saturations += place.saturated ? 1 : 0;
      for (int axis = 0; axis < 3; ++axis) piece_.p[i][axis] = round_half_up(place.p[axis]);
    }
    return true;
  }

  // On a wrapped axis, an edge whose ends are both at the far side of the map.
  bool on_seam(int edge, int axis) const {
    const bool wraps = axis == 0 ? regs_.map.wrap_u : regs_.map.wrap_v;
    const double size = axis == 0 ? regs_.map.width : regs_.map.height;
    return wraps && piece_.v[edge].u[axis] == size && piece_.v[(edge + 1) % 3].u[axis] == size;
  }

  struct named_vertex {
    remeshed_vertex name;
    swept_vertex v;
  };

  swept_vertex vertex_of(remeshed_vertex const& name, std::vector<named_vertex> const& before) {
    for (named_vertex const& known : before)
      if (known.name == name) return known.v;
    ++count_.vertices;
    swept_vertex v;
    bool saturated = false;
    if (name.kind == kind_corner) {
      base_vertex const& given = piece_.v[name.number];
      v.p = given.p;
      v.n = given.n;
      v.t = given.t;
      v.u = given.u;
      v.colour = given.colour;
    } else {
      interpolated_.name = name;
      const perspective_correction_out here =
          perspective_correction<Rounding>({interpolated_vertex<Rounding>(interpolated_)}, {regs_.limit});
      v.p = here.p;
      v.n = here.n;
      v.t = here.t;
      v.u = here.u;
      for (int axis = 0; axis < 2; ++axis)
        if (name.kind == kind_edge && on_seam(name.number, axis)) v.u[axis] = regs_.limit[axis];
      v.colour = here.colour;
      saturated = here.saturated;
    }
    const displace_out moved = displace<Rounding>({v.p, v.n, map_sampler<Rounding>({v.u}, regs_.map, texels_).d}, regs_.displace);
    const bump_out bent = bump<Rounding>({v.n, v.t, normal_sampler<Rounding>({v.u}, regs_.map, normals_).n});
    const transform_out seen = transform<Rounding>({moved.p}, regs_.transform);
    v.displaced_p = moved.p;
    v.displaced_n = bent.n;
    v.screen = seen.screen;
    v.w = seen.w;
    v.behind = seen.behind;
    count_.saturations += saturated || moved.saturated || bent.saturated ? 1 : 0;
    count_.screen_saturations += seen.saturated ? 1 : 0;
    count_.zero_vectors += bent.zero ? 1 : 0;
    return v;
  }

  template <class Put>
  void put_seen(named_vertex const& a, named_vertex const& b, named_vertex const& c, Put&& put) {
    const view_volume_clip_in in{{a.v.screen, b.v.screen, c.v.screen}, {a.v.w, b.v.w, c.v.w}, {a.v.behind, b.v.behind, c.v.behind}};
    if (view_volume_clip(in, {regs_.viewport, regs_.near, regs_.far}).rejected) {
      ++count_.unseen;
      return;
    }
    ++count_.triangles_out;
    put(swept_triangle{{a.v, b.v, c.v}, piece_.index, false, false, {a.name, b.name, c.name}, count_.pieces});
  }

  sweep_regs regs_;
  texel_memory texels_;
  normal_memory<Rounding, texel_memory> normals_;
  std::vector<double> z_table_;
  sweep_counters count_;
  swept_piece piece_;
  interpolated_vertex_in interpolated_;
};

}  // namespace golden
}  // namespace relievo
