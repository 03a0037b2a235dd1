// engine: base triangles in, adaptively tessellated and displaced triangles out.
//   Doggett & Hirche 2000, Figures 7 and 8: get triangle, calculate new P, displace vertex, transform, tessellation tests,
//   pass or tessellate, tessellate, triangle queue
//   in    stream of base triangles: P, N, T, U, index, last; generation 0, not settled, not displaced
//   regs  engine_regs;  memories displacement, summed-area table (read when use_sht), normal map
//   out   stream of triangle_out; the last one of a mesh carries last (a mesh of which all is culled gives one empty record)
//
//   Sequential, one triangle in flight. step() does one: it pops the queue, or reads the next base triangle when the queue is empty,
//   and writes at most two records. done() after the last one went out; start() begins the next mesh.
//   An edge that vt or ct stops reads no memory. A vertex on a split edge is displaced and transformed, its normal is transformed
//   on the next pass, as the paper has it.
#pragma once
#include "hls/core/stream.hpp"
#include "hls/edge/calculate_new_n.hpp"
#include "hls/edge/counters.hpp"
#include "hls/edge/displace_vertex.hpp"
#include "hls/edge/engine_regs.hpp"
#include "hls/edge/get_triangle.hpp"
#include "hls/edge/tessellate.hpp"
#include "hls/edge/tex_coord_test.hpp"
#include "hls/surface/bump.hpp"
#include "hls/surface/normal_sampler.hpp"

namespace relievo {
namespace hls {

template <int QueueDepth>
class engine {
 public:
  void start() {
    queue_.start();
    counters_ = counters();
    input_done_ = done_ = holding_ = false;
  }
  bool done() const { return done_; }
  bool wants_input() const { return queue_.empty() && !input_done_; }
  counters const& counts() const { return counters_; }

  template <class In, class Out>
  void step(In& in, Out& out, engine_regs const& regs, engine_memories const& memories) {
    if (queue_.empty() && input_done_) {
      finish(out);
      return;
    }
    if (queue_.empty()) {
      current_.t = in.read();
      input_done_ = current_.t.last;
      ++counters_.triangles_in;
    } else {
      bool fallback = false;
      current_.t = queue_.pop(regs.queue, regs.pass.max_generation, fallback);
      counters_.fifo_fallbacks += fallback ? 1 : 0;
    }
    const get_triangle_out work = get_triangle(current_.t, regs.pass.max_generation);
    for (int i = 0; i < 3; ++i) {
      current_.t.settled[i] = work.settled[i];
      if (work.new_surface[i]) place_base_vertex(current_.t.v[i], regs, memories);
      if (work.new_normal[i]) finish_normal(current_.t.v[i], regs);
    }
    int splits = 0;
    for (int i = 0; i < 3; ++i) {
      current_.split[i] = test_edge(i, regs, memories);
      splits += current_.split[i] ? 1 : 0;
    }
    ++counters_.splits[splits];
    if (splits == 0) {
      pass(out, regs);
    } else {
      tessellate(current_, regs.map, regs.pass.max_generation, children_);
      for (int i = 0; i < 4; ++i)
        if (i < raw(children_.count)) queue_.push(children_.t[i]);
      if (static_cast<std::uint64_t>(queue_.high_water()) > counters_.queue_high_water)
        counters_.queue_high_water = static_cast<std::uint64_t>(queue_.high_water());
    }
  }

 private:
  // P', P'_s of a vertex that enters the mesh.
  void place(vertex& v, engine_regs const& regs, engine_memories const& memories) {
    const displace_vertex_out moved = displace_vertex({{v.p[0], v.p[1], v.p[2]}, {v.n[0], v.n[1], v.n[2]}, {v.u[0], v.u[1]}}, regs.map,
                                                      regs.displace, memories.displacement);
    detail::copy(v.displaced_p, moved.p);
    const transform_out seen = transform({{moved.p[0], moved.p[1], moved.p[2]}}, regs.transform);
    detail::copy(v.screen, seen.screen);
    v.w = seen.w;
    v.behind = seen.behind;
    v.displaced = true;
    ++counters_.vertices;
    counters_.saturations += moved.saturated ? 1 : 0;
    counters_.screen_saturations += seen.saturated ? 1 : 0;
  }

  bump_out displaced_normal(vertex const& v, engine_regs const& regs, engine_memories const& memories) const {
    const normal_sampler_out m = normal_sampler({{v.u[0], v.u[1]}}, regs.map, memories.normals);
    return bump({{v.n[0], v.n[1], v.n[2]}, {v.t[0], v.t[1], v.t[2]}, {m.n[0], m.n[1], m.n[2]}});
  }

  void place_base_vertex(vertex& v, engine_regs const& regs, engine_memories const& memories) {
    place(v, regs, memories);
    const bump_out bumped = displaced_normal(v, regs, memories);
    detail::copy(v.displaced_n, bumped.n);
    counters_.saturations += bumped.saturated ? 1 : 0;
    counters_.zero_vectors += bumped.zero ? 1 : 0;
  }

  void finish_normal(vertex& v, engine_regs const& regs) const {
    const transform_normal_out seen =
        transform_normal({{v.displaced_p[0], v.displaced_p[1], v.displaced_p[2]}, {v.displaced_n[0], v.displaced_n[1], v.displaced_n[2]}},
                         regs.transform_normal);
    detail::copy(v.screen_n, seen.n);
    v.away = seen.away;
    v.transformed = true;
  }

  // Tests edge i of the current triangle; where it splits, its new vertex is complete but for N'_s.
  bool test_edge(int i, engine_regs const& regs, engine_memories const& memories) {
    if (current_.t.settled[i]) {
      ++counters_.settled_skips;
      return false;
    }
    ++counters_.edge_tests;
    vertex const &a = current_.t.v[i], &b = current_.t.v[(i + 1) % 3];
    vertex& m = current_.m[i];
    const auto middle = from_raw<formats::weight>(8);
    const calculate_new_u_out u12 = calculate_new_u({{a.u[0], a.u[1]}, {b.u[0], b.u[1]}, middle});

    pass_or_tessellate_in tests = {false, false, false, false, true, true, current_.t.generation[i], false};
    if (regs.pass.use_vt) {
      tests.vt = view_test({{a.screen[0], a.screen[1]}, {b.screen[0], b.screen[1]}, a.behind, b.behind}, regs.view).vt;
      if (!tests.vt) {
        ++counters_.vt;
        return false;
      }
    }
    if (regs.pass.use_ct) {
      tests.ct = tex_coord_test({{a.u[0], a.u[1]}, {b.u[0], b.u[1]}, {u12.u[0], u12.u[1]}}).ct;
      if (!tests.ct) {
        ++counters_.ct;
        return false;
      }
    }
    if (regs.pass.use_sht) {
      tests.sht =
          summed_height_test({{a.u[0], a.u[1]}, {b.u[0], b.u[1]}, {u12.u[0], u12.u[1]}}, regs.map, regs.summed_height, memories.table).sht;
      counters_.sht += tests.sht ? 1 : 0;
      counters_.table_reads += 12;
    }
    fixed<formats::weight> k = middle;
    if (regs.pass.use_pt) {
      const int levels = detail::profile_levels(a.u, b.u);
      if (levels != 0) counters_.profile_samples += static_cast<std::uint64_t>((1 << levels) + 1);
      const profile_test_out profile =
          profile_test({{a.u[0], a.u[1]}, {b.u[0], b.u[1]}, precedes(a, b, regs.map)}, regs.map, regs.profile, memories.displacement);
      tests.pt = profile.pt;
      k = profile.k;
      counters_.pt += tests.pt ? 1 : 0;
    }
    // What only the normal and highlight tests need is left out where neither can change the decision.
    const bool needs_normal = regs.pass.use_nt || regs.pass.use_ht;
    if (!needs_normal && !tests.sht && !tests.pt) return false;

    const zero_count zeros = new_vertex(a, b, k, u12, m, regs, memories);
    if (regs.pass.use_nt) {
      tests.nt = normal_test({{a.displaced_n[0], a.displaced_n[1], a.displaced_n[2]},
                              {b.displaced_n[0], b.displaced_n[1], b.displaced_n[2]},
                              {m.displaced_n[0], m.displaced_n[1], m.displaced_n[2]}},
                             regs.normal)
                     .nt;
      counters_.nt += tests.nt ? 1 : 0;
    }
    if (regs.pass.use_ht) {
      tests.ht = highlight_test({{a.displaced_n[0], a.displaced_n[1], a.displaced_n[2]},
                                 {b.displaced_n[0], b.displaced_n[1], b.displaced_n[2]},
                                 {m.displaced_n[0], m.displaced_n[1], m.displaced_n[2]}},
                                regs.highlight)
                     .ht;
      counters_.ht += tests.ht ? 1 : 0;
    }
    if (!pass_or_tessellate(tests, regs.pass).split) return false;
    place(m, regs, memories);
    counters_.saturations += zeros.saturated ? 1 : 0;
    counters_.zero_vectors += zeros.zeros;
    return true;
  }

  struct zero_count {
    bool saturated;
    std::uint64_t zeros;
  };

  // P, U, N, T and N' at k/16 of the edge.
  zero_count new_vertex(vertex const& a, vertex const& b, fixed<formats::weight> k, calculate_new_u_out const& u12, vertex& m,
                        engine_regs const& regs, engine_memories const& memories) const {
    const calculate_new_p_out p = calculate_new_p({{a.p[0], a.p[1], a.p[2]}, {b.p[0], b.p[1], b.p[2]}, k});
    detail::copy(m.p, p.p);
    const calculate_new_u_out u = raw(k) == 8 ? u12 : calculate_new_u({{a.u[0], a.u[1]}, {b.u[0], b.u[1]}, k});
    detail::copy(m.u, u.u);
    const calculate_new_n_out n = calculate_new_n({{a.n[0], a.n[1], a.n[2]}, {b.n[0], b.n[1], b.n[2]}, k, false});
    detail::copy(m.n, n.n);
    const calculate_new_n_out t = calculate_new_n({{a.t[0], a.t[1], a.t[2]}, {b.t[0], b.t[1], b.t[2]}, k, true});
    detail::copy(m.t, t.n);
    const bump_out bumped = displaced_normal(m, regs, memories);
    detail::copy(m.displaced_n, bumped.n);
    for (int i = 0; i < 3; ++i) m.screen_n[i] = from_raw<formats::unit>(0);
    m.away = false;
    m.transformed = false;
    return {bumped.saturated,
            static_cast<std::uint64_t>(n.zero) + static_cast<std::uint64_t>(t.zero) + static_cast<std::uint64_t>(bumped.zero)};
  }

  // Puts the current triangle out, one record late so that the last of the mesh can say so.
  template <class Out>
  void pass(Out& out, engine_regs const& regs) {
    if (cull({current_.t.v[0].away, current_.t.v[1].away, current_.t.v[2].away}, regs.pass)) {
      ++counters_.culled;
      return;
    }
    ++counters_.triangles_out;
    if (holding_) out.write(held_);
    held_ = to_output(current_.t);
    holding_ = true;
  }

  template <class Out>
  void finish(Out& out) {
    if (!holding_) {
      held_ = triangle_out();
      held_.empty = true;
    }
    held_.last = true;
    out.write(held_);
    done_ = true;
  }

  triangle_queue<QueueDepth> queue_;
  tessellate_in current_;
  tessellate_out children_;
  triangle_out held_;
  counters counters_;
  bool input_done_ = false;
  bool done_ = false;
  bool holding_ = false;
};

}  // namespace hls
}  // namespace relievo
