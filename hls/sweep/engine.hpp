// engine: base triangles in, displaced triangles of the size of a cell of the grid out.
//   Gumhold & Huettner 1999, Figures 3 and 5: near_clip, transform, base_triangle_clip, grid_transform, perspective_preparation,
//   difference_vertices, sweep_line with data, perspective_correction, map_sampler, displace and bump, transform, view_volume_clip
//   in    stream of base_triangle
//   regs  sweep_regs;  memories displacement, normal map, z table (257 words of z_table for kappa)
//   out   stream of swept_triangle; the last one of a mesh carries last (a mesh of which nothing is seen gives one empty record)
//
//   step() does one thing: it reads a base triangle and cuts it, or sets up the next piece of it, or walks one primitive and writes at
//   most two records. done() after the last one went out; start() begins the next mesh. A triangle that near_clip cut is the fan of its
//   polygon, piece after piece; any other is one piece. The vertices of the primitive before are kept (the paper's stripping unit has
//   registers for as many), so a quad computes two new ones within a strip.
//   A vertex of an edge depends on the edge's two ends alone. Along an edge with U = W at both ends, where a wrapped axis closes, U is W:
//   the neighbour has exactly 0 there, and W c / c would have an error.
//   Displacement unfiltered, at U; the colour passes.
//   sequential; a primitive a step
#pragma once
#include "hls/core/stream.hpp"
#include "hls/surface/bump.hpp"
#include "hls/surface/map_sampler.hpp"
#include "hls/surface/normal_sampler.hpp"
#include "hls/sweep/base_triangle_clip.hpp"
#include "hls/sweep/engine_data.hpp"
#include "hls/sweep/grid_transform.hpp"
#include "hls/sweep/near_clip.hpp"
#include "hls/sweep/perspective_correction.hpp"
#include "hls/sweep/perspective_preparation.hpp"
#include "hls/sweep/sweep_line.hpp"
#include "hls/sweep/view_volume_clip.hpp"
#include "hls/sweep/walk_data.hpp"

namespace relievo {
namespace hls {

namespace detail {

template <class T, int N>
inline void copy_words(T (&to)[N], T const (&from)[N]) {
  for (int i = 0; i < N; ++i) to[i] = from[i];
}
// P, N, T, U and the colour, of whatever record has them.
template <class To, class From>
inline void copy_attributes(To& to, From const& from) {
  copy_words(to.p, from.p);
  copy_words(to.n, from.n);
  copy_words(to.t, from.t);
  copy_words(to.u, from.u);
  copy_words(to.colour, from.colour);
}
inline bool same_name(remeshed_vertex const& a, remeshed_vertex const& b) {
  return a.kind == b.kind && a.number == b.number && a.i == b.i && a.s == b.s && a.t == b.t;
}

}  // namespace detail

class sweep_engine {
 public:
  void start() {
    counters_ = sweep_counters();
    additions_ = 0;
    polygon_.count = from_raw<format<4, 4, false>>(0);
    fan_ = 0;
    input_done_ = done_ = holding_ = walking_ = false;
  }
  bool done() const { return done_; }
  bool wants_input() const { return !walking_ && !has_piece() && !input_done_; }
  sweep_counters const& counts() const { return counters_; }
  // Vector additions of all walks so far; those that set a strip up count with its first primitive.
  std::uint64_t additions() const { return additions_; }
  // What the step that went before did: for benches, no part of the hardware's ports.
  bool began_piece() const { return began_piece_; }
  base_triangle const& piece() const { return piece_; }
  bool walks() const { return walking_; }
  sweep_line_in const& places() const { return places_; }
  sweep_setup const& setup() const { return walk_.setup(); }
  primitive const& walked() const { return walked_; }
  bool put_out(int half) const { return put_out_[half]; }

  template <class In, class Out>
  void step(In& in, Out& out, sweep_regs const& regs, sweep_memories const& memories) {
    began_piece_ = put_out_[0] = put_out_[1] = false;
    if (walking_) {
      walk(out, regs, memories);
    } else if (has_piece()) {
      set_up(regs, memories);
    } else if (!input_done_) {
      cut(in.read(), regs);
    } else {
      finish(out);
    }
  }

 private:
  // A polygon of n vertices has n - 2 pieces.
  bool has_piece() const { return fan_ + 2 < static_cast<int>(raw(polygon_.count)); }

  void cut(base_triangle const& t, sweep_regs const& regs) {
    near_clip_in corners;
    for (int i = 0; i < 3; ++i) corners.vertex[i] = t.v[i];
    polygon_ = near_clip(corners, {regs.transform, regs.near, regs.far, regs.guard});
    piece_.index = t.index;
    piece_.last = input_done_ = t.last;
    fan_ = 0;
    ++counters_.triangles_in;
    counters_.cut += polygon_.inside || polygon_.empty ? 0 : 1;
    counters_.outside += polygon_.empty ? 1 : 0;
    counters_.overflows += polygon_.overflow ? 1 : 0;
  }

  void set_up(sweep_regs const& regs, sweep_memories const& memories) {
    began_piece_ = true;
    piece_.v[0] = polygon_.vertex[0];
    piece_.v[1] = polygon_.vertex[fan_ + 1];
    piece_.v[2] = polygon_.vertex[fan_ + 2];
    ++fan_;
    ++counters_.pieces;

    base_triangle_clip_in seen;
    for (int i = 0; i < 3; ++i) {
      const transform_out corner = transform({{piece_.v[i].p[0], piece_.v[i].p[1], piece_.v[i].p[2]}}, regs.transform);
      detail::copy_words(seen.screen[i], corner.screen);
      seen.w[i] = corner.w;
      counters_.screen_saturations += corner.saturated ? 1 : 0;
    }
    seen.d_max = regs.d_max;
    if (base_triangle_clip(seen, {{regs.viewport[0], regs.viewport[1]}, {regs.reach[0], regs.reach[1]}, regs.near, regs.far, regs.d_scale})
            .rejected) {
      ++counters_.rejected;
      return;
    }
    for (int i = 0; i < 3; ++i) {
      const grid_transform_out place = grid_transform({{seen.screen[i][0], seen.screen[i][1]}, seen.w[i]}, regs.grid, memories.z);
      detail::copy_words(places_.p[i], place.p);
      counters_.grid_saturations += place.saturated ? 1 : 0;
    }
    const sweep_setup setup = hls::set_up(places_);
    difference_vertices_in differences;
    for (int i = 0; i < 3; ++i) detail::copy_words(differences.p[i], places_.p[i]);
    differences.plane = setup.plane;
    prepare(setup, seen, regs, differences);
    walk_.start(places_, setup, walk_data_of(differences, difference_vertices(differences)));
    count_additions();
    kept_ = 0;
    walking_ = true;
  }

  // The blocks of the corners and of each edge's two ends, the canonical one first.
  void prepare(sweep_setup const& setup, base_triangle_clip_in const& seen, sweep_regs const& regs, difference_vertices_in& out) {
    const block_power block = block_exponent(seen.w[0], seen.w[1], seen.w[2]);
    for (int e = 0; e < 3; ++e) {
      const int next = detail::after(e), axis = detail::of(setup.main[e].axis);
      const bool rising = places_.p[e][axis] <= places_.p[next][axis];
      const int canonical = rising ? e : next, other = rising ? next : e;
      const block_power edge = block_exponent(seen.w[e], seen.w[next]);
      out.corner[e] = perspective_preparation({piece_.v[e], seen.w[e], block});
      out.end[e][0] = perspective_preparation({piece_.v[canonical], seen.w[canonical], edge});
      out.end[e][1] = perspective_preparation({piece_.v[other], seen.w[other], edge});
      for (int a = 0; a < 2; ++a) {
        const bool wraps = a == 0 ? regs.map.wrap_u : regs.map.wrap_v;
        seam_[e][a] = wraps && piece_.v[e].u[a] == regs.limit[a] && piece_.v[next].u[a] == regs.limit[a];
      }
    }
  }

  template <class Out>
  void walk(Out& out, sweep_regs const& regs, sweep_memories const& memories) {
    vertex_steps data[4];
    walking_ = !walk_.step(walked_, data);
    count_additions();
    ++counters_.primitives;
    counters_.quads += walked_.quad ? 1 : 0;
    const int count = walked_.quad ? 4 : 3;
    swept_vertex now[4];
    for (int i = 0; i < 4; ++i)
      if (i < count && !find(walked_.v[i], now[i])) now[i] = vertex_of(walked_.v[i], data[i], regs, memories);
    for (int i = 0; i < 4; ++i) {
      kept_names_[i] = walked_.v[i];
      kept_vertices_[i] = now[i];
    }
    kept_ = count;
    put_seen(0, now[0], now[1], walked_.quad ? now[3] : now[2], out, regs);
    if (walked_.quad) put_seen(1, now[1], now[2], now[3], out, regs);
  }

  // Three corners on one place of the grid are not walked.
  void count_additions() {
    if (detail::of(walk_.setup().cases.kind) != point_case) additions_ += static_cast<std::uint64_t>(walk_.remeshing().walk().additions());
  }

  bool find(remeshed_vertex const& name, swept_vertex& out) const {
    for (int i = 0; i < 4; ++i)
      if (i < kept_ && detail::same_name(kept_names_[i], name)) {
        out = kept_vertices_[i];
        return true;
      }
    return false;
  }

  swept_vertex vertex_of(remeshed_vertex const& name, vertex_steps const& data, sweep_regs const& regs, sweep_memories const& memories) {
    swept_vertex v;
    bool saturated = false;
    if (raw(name.kind) == corner_vertex) {
      detail::copy_attributes(v, piece_.v[detail::of(name.number)]);
    } else {
      const perspective_correction_out here = perspective_correction({data}, {{regs.limit[0], regs.limit[1]}});
      detail::copy_attributes(v, here);
      saturated = here.saturated;
      for (int a = 0; a < 2; ++a)
        if (raw(name.kind) == edge_vertex && seam_[detail::of(name.number)][a]) v.u[a] = regs.limit[a];
    }
    place(v, saturated, regs, memories);
    return v;
  }

  // P', N' and P'_s of a vertex on the base surface.
  void place(swept_vertex& v, bool saturated, sweep_regs const& regs, sweep_memories const& memories) {
    const map_sampler_out height = map_sampler({{v.u[0], v.u[1]}}, regs.map, memories.displacement);
    const displace_out moved = displace({{v.p[0], v.p[1], v.p[2]}, {v.n[0], v.n[1], v.n[2]}, height.d}, regs.displace);
    const normal_sampler_out m = normal_sampler({{v.u[0], v.u[1]}}, regs.map, memories.normals);
    const bump_out bent = bump({{v.n[0], v.n[1], v.n[2]}, {v.t[0], v.t[1], v.t[2]}, {m.n[0], m.n[1], m.n[2]}});
    const transform_out seen = transform({{moved.p[0], moved.p[1], moved.p[2]}}, regs.transform);
    detail::copy_words(v.displaced_p, moved.p);
    detail::copy_words(v.displaced_n, bent.n);
    detail::copy_words(v.screen, seen.screen);
    v.w = seen.w;
    v.behind = seen.behind;
    ++counters_.vertices;
    counters_.saturations += saturated || moved.saturated || bent.saturated ? 1 : 0;
    counters_.screen_saturations += seen.saturated ? 1 : 0;
    counters_.zero_vectors += bent.zero ? 1 : 0;
  }

  // Puts a triangle out unless it cannot be seen, one record late so that the last of the mesh can say so.
  template <class Out>
  void put_seen(int half, swept_vertex const& a, swept_vertex const& b, swept_vertex const& c, Out& out, sweep_regs const& regs) {
    view_volume_clip_in in;
    swept_vertex const* const v[3] = {&a, &b, &c};
    for (int i = 0; i < 3; ++i) {
      detail::copy_words(in.screen[i], v[i]->screen);
      in.w[i] = v[i]->w;
      in.behind[i] = v[i]->behind;
    }
    if (view_volume_clip(in, {{regs.viewport[0], regs.viewport[1]}, regs.near, regs.far}).rejected) {
      ++counters_.unseen;
      return;
    }
    put_out_[half] = true;
    ++counters_.triangles_out;
    if (holding_) out.write(held_);
    for (int i = 0; i < 3; ++i) held_.v[i] = *v[i];
    held_.index = piece_.index;
    held_.empty = held_.last = false;
    holding_ = true;
  }

  template <class Out>
  void finish(Out& out) {
    if (!holding_) {
      held_ = swept_triangle();
      held_.empty = true;
    }
    held_.last = true;
    out.write(held_);
    done_ = true;
  }

  near_clip_out polygon_;
  int fan_ = 0;
  base_triangle piece_;
  sweep_line_in places_;
  bool seam_[3][2];
  sweep_line_of<vertex_steps> walk_;
  primitive walked_;
  remeshed_vertex kept_names_[4];
  swept_vertex kept_vertices_[4];
  int kept_ = 0;
  swept_triangle held_;
  sweep_counters counters_;
  std::uint64_t additions_ = 0;
  bool input_done_ = false, done_ = false, holding_ = false, walking_ = false;
  bool began_piece_ = false;
  bool put_out_[2];
};

}  // namespace hls
}  // namespace relievo
