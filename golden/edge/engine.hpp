// engine: adaptive tessellation of a displaced mesh, one triangle in flight.   Doggett & Hirche 2000, sections 2 and 3, figure 7
//
//   engine<Rounding>(registers, memories, queue_depth).run(next, out, observer) -> counters
//     next(triangle&) -> bool       the next base triangle: P, N, T, U and index filled in; false when there is none
//     out(triangle_out const&)      a finished triangle; the last one carries `last`, an empty record does when there is none
//     observer(edge_trace const&)   every edge that was tested
//
// Until queue and mesh are empty, a triangle is taken (from the queue first), its missing vertices are set up, each edge that
// is not settled is tested from the records of its two ends alone, and the triangle is put out or tessellated into the queue.
// queue_depth >= 3 max_generation + 4; a queue that overflows throws std::length_error.
#pragma once
#include <cstddef>
#include <cstdint>

#include "golden/edge/calculate_new_n.hpp"
#include "golden/edge/calculate_new_p.hpp"
#include "golden/edge/calculate_new_u.hpp"
#include "golden/edge/counters.hpp"
#include "golden/edge/displace_vertex.hpp"
#include "golden/edge/edge_trace.hpp"
#include "golden/edge/engine_regs.hpp"
#include "golden/edge/get_triangle.hpp"
#include "golden/edge/tessellate.hpp"
#include "golden/edge/tex_coord_test.hpp"
#include "golden/edge/triangle.hpp"
#include "golden/edge/triangle_queue.hpp"
#include "golden/surface/bump.hpp"
#include "golden/surface/memories.hpp"
#include "golden/surface/normal_sampler.hpp"

namespace relievo {
namespace golden {

template <class Rounding>
class engine {
 public:
  engine(engine_regs const& regs, memories const& maps, std::size_t queue_depth)
      : regs_(regs),
        texels_(maps.texels, regs.map),
        table_(maps.table, regs.map),
        normals_(texels_, regs.map, maps.normal_map),
        queue_depth_(queue_depth) {}

  template <class Next, class Out, class Observer>
  counters run(Next&& next, Out&& out, Observer&& observer) {
    count_ = counters{};
    triangle_queue queue(queue_depth_, regs_.queue, regs_.pass.max_generation);
    triangle_out held;
    bool holding = false;
    for (;;) {
      triangle t;
      if (!queue.empty()) {
        t = queue.pop();
      } else if (next(t)) {
        begin(t);
      } else {
        break;
      }
      set_up(t);
      tessellate_in in;
      int splits = 0;
      for (int i = 0; i < 3; ++i) {
        if (t.settled[i]) {
          ++count_.settled_skips;
          continue;
        }
        edge_trace const edge = test_edge(t, i);
        observer(edge);
        in.split[i] = edge.split;
        in.m[i] = edge.m;
        splits += edge.split ? 1 : 0;
      }
      ++count_.splits[splits];
      if (splits > 0) {
        in.t = t;
        const tessellate_out parts = tessellate<Rounding>(in, regs_.map, regs_.pass.max_generation);
        for (int i = 0; i < parts.count; ++i) queue.push(parts.t[i]);
      } else if (cull<Rounding>({t.v[0].away, t.v[1].away, t.v[2].away}, regs_.pass)) {
        ++count_.culled;
      } else {
        ++count_.triangles_out;
        if (holding) out(held);
        held = triangle_out{{leaving(t.v[0]), leaving(t.v[1]), leaving(t.v[2])}, t.index, false, false, t.path};
        holding = true;
      }
    }
    held.empty = !holding;
    held.last = true;
    out(held);
    count_.queue_high_water = queue.high_water();
    count_.fifo_fallbacks = queue.fallbacks();
    return count_;
  }

  template <class Next, class Out>
  counters run(Next&& next, Out&& out) {
    return run(next, out, [](edge_trace const&) {});
  }

 private:
  void begin(triangle& t) {
    ++count_.triangles_in;
    t.path = 1;
    for (int i = 0; i < 3; ++i) {
      t.v[i].barycentric = {};
      t.v[i].barycentric[static_cast<std::size_t>(i)] = std::int64_t{1} << 60;
    }
  }

  // P', N' and P'_s of vertices that have none yet, N'_s of those that only lack that; which edges are settled.
  void set_up(triangle& t) {
    const get_triangle_out needs = get_triangle<Rounding>(t, regs_.pass.max_generation);
    for (int i = 0; i < 3; ++i) {
      t.settled[i] = needs.settled[i];
      vertex& v = t.v[i];
      if (needs.new_surface[i]) {
        bend(v);
        count_.zero_vectors += bent_.zero ? 1 : 0;
        enter(v);
      }
      if (needs.new_normal[i]) {
        const auto turned = transform_normal<Rounding>({v.displaced_p, v.displaced_n}, regs_.transform_normal);
        v.screen_n = turned.n;
        v.away = turned.away;
        v.transformed = true;
      }
    }
  }

  // N' of a vertex.
  void bend(vertex& v) {
    const glm::dvec3 m = normal_sampler<Rounding>({v.u}, regs_.map, normals_).n;
    bent_ = bump<Rounding>({v.n, v.t, m});
    v.displaced_n = bent_.n;
  }

  // P' and P'_s of a vertex that enters the mesh right after its bend().
  void enter(vertex& v) {
    const auto moved = displace_vertex<Rounding>({v.p, v.n, v.u}, regs_.map, regs_.displace, texels_);
    const auto seen = transform<Rounding>({moved.p}, regs_.transform);
    v.displaced_p = moved.p;
    v.screen = seen.screen;
    v.w = seen.w;
    v.behind = seen.behind;
    v.displaced = true;
    ++count_.vertices;
    count_.saturations += (moved.saturated ? 1 : 0) + (bent_.saturated ? 1 : 0);
    count_.screen_saturations += seen.saturated ? 1 : 0;
  }

  edge_trace test_edge(triangle const& t, int i) {
    ++count_.edge_tests;
    edge_trace e;
    e.index = t.index;
    e.path = t.path;
    e.edge = i;
    e.generation = t.generation[i];
    e.v1 = t.v[i];
    e.v2 = t.v[(i + 1) % 3];
    const glm::dvec2 u12 = calculate_new_u<Rounding>({e.v1.u, e.v2.u, 8}).u;

    if (regs_.pass.use_vt) {
      const view_test_in in{e.v1.screen, e.v2.screen, e.v1.behind, e.v2.behind};
      e.vt = {true, view_test<Rounding>(in, regs_.view).vt, view_test_measure(in), regs_.view.threshold};
    }
    if (regs_.pass.use_ct) e.ct = {true, tex_coord_test<Rounding>({e.v1.u, e.v2.u, u12}).ct, 0, 0};
    if (e.vt.evaluated && !e.vt.value) {
      ++count_.vt;
      return e;
    }
    if (e.ct.evaluated && !e.ct.value) {
      ++count_.ct;
      return e;
    }

    if (regs_.pass.use_sht) {
      const summed_height_test_in in{e.v1.u, e.v2.u, u12};
      const auto sides = summed_height_measure<Rounding>(in, regs_.map, regs_.summed_height, table_);
      const bool sht = summed_height_test<Rounding>(in, regs_.map, regs_.summed_height, table_).sht;
      e.sht = {true, sht, sides.measure, sides.threshold};
      count_.table_reads += 12;
    }
    if (regs_.pass.use_pt) {
      const profile_test_in in{e.v1.u, e.v2.u, precedes(e.v1, e.v2, regs_.map)};
      const profile_deviations profile = profile_of<Rounding>(in, regs_.map, texels_);
      const profile_test_out out = profile_test<Rounding>(in, regs_.map, regs_.profile, texels_);
      e.pt = {true, out.pt, profile.measure(), profile.n * regs_.profile.threshold};
      e.k = out.k;
      e.intervals = profile.n;
      if (profile.n > 0) count_.profile_samples += static_cast<std::uint64_t>(profile.n) + 1;
    }

    vertex& m = e.m;
    m.p = calculate_new_p<Rounding>({e.v1.p, e.v2.p, e.k}).p;
    m.u = calculate_new_u<Rounding>({e.v1.u, e.v2.u, e.k}).u;
    const auto n = calculate_new_n<Rounding>({e.v1.n, e.v2.n, e.k, false});
    const auto tangent = calculate_new_n<Rounding>({e.v1.t, e.v2.t, e.k, true});
    m.n = n.n;
    m.t = tangent.n;
    for (std::size_t b = 0; b < 3; ++b) {
      // At most 4 bits a generation and 15 generations: dividing first loses nothing.
      const auto k = static_cast<std::int64_t>(e.k);
      m.barycentric[b] = e.v1.barycentric[b] / 16 * (16 - k) + e.v2.barycentric[b] / 16 * k;
    }
    bend(m);
    if (regs_.pass.use_nt) {
      const normal_test_in in{e.v1.displaced_n, e.v2.displaced_n, m.displaced_n};
      e.nt = {true, normal_test<Rounding>(in, regs_.normal).nt, normal_test_measure(in), regs_.normal.threshold};
    }
    if (regs_.pass.use_ht) {
      const highlight_test_in in{e.v1.displaced_n, e.v2.displaced_n, m.displaced_n};
      e.ht = {true, highlight_test<Rounding>(in, regs_.highlight).ht, highlight_test_measure(in, regs_.highlight),
              regs_.highlight.threshold};
    }
    count_.nt += e.nt.value ? 1 : 0;
    count_.sht += e.sht.value ? 1 : 0;
    count_.pt += e.pt.value ? 1 : 0;
    count_.ht += e.ht.value ? 1 : 0;

    e.split = pass_or_tessellate<Rounding>(
                  {e.nt.value, e.sht.value, e.pt.value, e.ht.value, e.vt.value, e.ct.value, e.generation, t.settled[i]}, regs_.pass)
                  .split;
    if (e.split) {
      count_.zero_vectors += (n.zero ? 1 : 0) + (tangent.zero ? 1 : 0) + (bent_.zero ? 1 : 0);
      enter(m);
    }
    return e;
  }

  engine_regs regs_;
  texel_memory texels_;
  table_memory table_;
  normal_memory<Rounding, texel_memory> normals_;
  std::size_t queue_depth_;
  counters count_;
  bump_out bent_;
};

}  // namespace golden
}  // namespace relievo
