// redecide: what the ideal model says about an edge that golden decided, from golden's own end records.
//
// Two trees cannot be compared after one differing split, single edges can. Every enabled test is evaluated again with
// Rounding = exact; the new vertex stands where golden put it (its k), so that nt and ht judge the same point.
//
//   redecide(registers, memories)(edge_trace) -> redecision
//     per test   golden, ideal   the two decisions;  golden_measure, ideal_measure, threshold
//                margin          |ideal_measure - threshold|; for ct how far U12 is below the next texel, in texels
//                bound           derived largest |golden_measure - ideal_measure| (decision_bounds.hpp)
//                explained()     they agree, or differ within the bound
//     k, m       where the ideal would have put the vertex, and its ideal record at golden's k
//     split      the ideal decision
//     middle_moved   sht was judged at golden's midpoint: its register moved it to the next texel, within one LSB of U
//
// A test that golden did not reach (vt or ct stopped the edge) is evaluated for the ideal decision alone: compared is false.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "golden/edge/calculate_new_n.hpp"
#include "golden/edge/calculate_new_p.hpp"
#include "golden/edge/calculate_new_u.hpp"
#include "golden/edge/decision_bounds.hpp"
#include "golden/edge/displace_vertex.hpp"
#include "golden/edge/edge_trace.hpp"
#include "golden/edge/engine_regs.hpp"
#include "golden/edge/tex_coord_test.hpp"
#include "golden/surface/bump.hpp"
#include "golden/surface/memories.hpp"
#include "golden/surface/normal_sampler.hpp"

namespace relievo {
namespace golden {

struct test_redecision {
  bool compared = false;
  bool golden = false, ideal = false;
  double golden_measure = 0, ideal_measure = 0, threshold = 0;
  double margin = 0;
  double bound = 0;

  bool differs() const { return compared && golden != ideal; }
  bool explained() const { return !differs() || margin <= bound; }
};

struct redecision {
  test_redecision vt, ct, nt, sht, pt, ht;
  double k = 8;
  vertex m;
  bool split = false;
  bool middle_moved = false;
};

class redecide {
 public:
  redecide(engine_regs const& regs, memories const& maps)
      : regs_(regs),
        texels_(maps.texels, regs.map),
        table_(maps.table, regs.map),
        normal_shift_(maps.normal_map.normal_shift),
        normals_(texels_, regs.map, maps.normal_map) {}

  redecision operator()(edge_trace const& e) const {
    redecision out;
    const glm::dvec2 u12 = calculate_new_u<exact>({e.v1.u, e.v2.u, 8}).u;
    const glm::dvec2 u12_rounded = calculate_new_u<rounded>({e.v1.u, e.v2.u, 8}).u;
    auto const& use = regs_.pass;

    if (use.use_vt) {
      const view_test_in in{e.v1.screen, e.v2.screen, e.v1.behind, e.v2.behind};
      out.vt = compare(e.vt, view_test<exact>(in, regs_.view).vt, view_test_measure(in), regs_.view.threshold, 0);
    }
    if (use.use_ct) {
      out.ct = compare(e.ct, tex_coord_test<exact>({e.v1.u, e.v2.u, u12}).ct, 0, 0, half_lsb<formats::coordinate>());
      const glm::dvec2 below = glm::floor(u12) + 1.0 - u12;
      out.ct.margin = std::min(below.x, below.y);
    }
    if (use.use_sht) {
      // Where the register moves the midpoint to the next texel, the middle rectangle moves with it, as ct's decision would: such an edge
      // is judged at golden's midpoint and counted, so that the margin says what the arithmetic does.
      out.middle_moved = glm::floor(u12) != glm::floor(u12_rounded);
      const glm::dvec2 middle = out.middle_moved ? u12_rounded : u12;
      const summed_height_test_in in{e.v1.u, e.v2.u, middle};
      const auto sides = summed_height_measure<exact>(in, regs_.map, regs_.summed_height, table_);
      out.sht = compare(e.sht, summed_height_test<exact>(in, regs_.map, regs_.summed_height, table_).sht, sides.measure, sides.threshold,
                        summed_height_bound(e.v1.u, e.v2.u, middle, regs_.map) + exact::noise(sides.scale));
    }
    if (use.use_pt) {
      const profile_test_in in{e.v1.u, e.v2.u, precedes(e.v1, e.v2, regs_.map)};
      const profile_test_out ideal = profile_test<exact>(in, regs_.map, regs_.profile, texels_);
      const profile_deviations profile = profile_of<exact>(in, regs_.map, texels_);
      out.pt = compare(e.pt, ideal.pt, profile.measure(), profile.n * regs_.profile.threshold, profile_bound(in, regs_.map, texels_));
      out.k = ideal.k;
    }

    const double k = e.pt.evaluated || !use.use_pt ? e.k : out.k;
    new_normal_terms terms;
    out.m = vertex_at(e, k, terms);
    const normal_test_in normals{e.v1.displaced_n, e.v2.displaced_n, out.m.displaced_n};
    const highlight_test_in lit{e.v1.displaced_n, e.v2.displaced_n, out.m.displaced_n};
    const new_normal_bound_out bound = new_normal_bound(terms);
    if (use.use_nt)
      out.nt = compare(e.nt, normal_test<exact>(normals, regs_.normal).nt, normal_test_measure(normals), regs_.normal.threshold,
                       bound.component);
    if (use.use_ht)
      out.ht = compare(e.ht, highlight_test<exact>(lit, regs_.highlight).ht, highlight_test_measure(lit, regs_.highlight),
                       regs_.highlight.threshold, bound.length * glm::length(regs_.highlight.half_vector));
    out.split = pass_or_tessellate<exact>(
                    {out.nt.ideal, out.sht.ideal, out.pt.ideal, out.ht.ideal, out.vt.ideal, out.ct.ideal, e.generation, false}, use)
                    .split;
    return out;
  }

 private:
  static test_redecision compare(test_trace const& golden, bool ideal, double measure, double threshold, double bound) {
    return {golden.evaluated, golden.value, ideal, golden.measure, measure, threshold, std::abs(measure - threshold), bound};
  }

  // The ideal record of a new vertex, and what the bound of its N' depends on.
  vertex vertex_at(edge_trace const& e, double k, new_normal_terms& terms) const {
    vertex m;
    m.p = calculate_new_p<exact>({e.v1.p, e.v2.p, k}).p;
    m.u = calculate_new_u<exact>({e.v1.u, e.v2.u, k}).u;
    m.n = calculate_new_n<exact>({e.v1.n, e.v2.n, k, false}).n;
    m.t = calculate_new_n<exact>({e.v1.t, e.v2.t, k, true}).n;
    const glm::dvec3 map_normal = normal_sampler<exact>({m.u}, regs_.map, normals_).n;
    m.displaced_n = bump<exact>({m.n, m.t, map_normal}).n;
    m.displaced_p = displace_vertex<exact>({m.p, m.n, m.u}, regs_.map, regs_.displace, texels_).p;
    const transform_out seen = transform<exact>({m.displaced_p}, regs_.transform);
    m.screen = seen.screen;
    m.w = seen.w;
    m.behind = seen.behind;
    m.displaced = true;
    const glm::dvec2 u_rounded = calculate_new_u<rounded>({e.v1.u, e.v2.u, k}).u;
    terms.n1 = e.v1.n;
    terms.n2 = e.v2.n;
    terms.t1 = e.v1.t;
    terms.t2 = e.v2.t;
    terms.k = k;
    terms.n = m.n;
    terms.t = m.t;
    terms.m = map_normal;
    terms.normal_change = change_by_rounding(m.u, u_rounded, regs_.map, normals_);
    terms.shortest_direction = shortest_direction(m.u, u_rounded, regs_.map, normal_shift_, normals_);
    return m;
  }

  engine_regs regs_;
  texel_memory texels_;
  table_memory table_;
  double normal_shift_;
  normal_memory<exact, texel_memory> normals_;
};

}  // namespace golden
}  // namespace relievo
