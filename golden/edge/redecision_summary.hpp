// redecision_summary: the distance between ideal and golden over all edges of a run, for the report of a scene.
//
//   summary.add(trace, redecision) for every tested edge, then
//     per test    compared, differing; unexplained   differing outside the derived bound: 0, or the model is wrong
//                 largest_change                     |golden measure - ideal measure|
//                 largest_bound                      its derived bound
//                 largest_margin, largest_share      of the differing decisions: |ideal measure - threshold|, and that
//                                                    divided by the threshold
//     splits, places   edges whose split or whose k the ideal would have chosen otherwise
//     middles_moved    edges whose sht was judged at golden's midpoint (redecide)
//     per register     error of new vertices in LSB, given the same end records: max and RMS
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "golden/edge/redecide.hpp"

namespace relievo {
namespace golden {

struct test_summary {
  std::uint64_t compared = 0, differing = 0, unexplained = 0;
  double largest_change = 0, largest_bound = 0;
  double largest_margin = 0, largest_share = 0;

  void add(test_redecision const& t) {
    if (!t.compared) return;
    ++compared;
    largest_change = std::max(largest_change, std::abs(t.golden_measure - t.ideal_measure));
    largest_bound = std::max(largest_bound, t.bound);
    if (!t.differs()) return;
    ++differing;
    unexplained += t.explained() ? 0 : 1;
    largest_margin = std::max(largest_margin, t.margin);
    if (t.threshold > 0) largest_share = std::max(largest_share, t.margin / t.threshold);
  }
};

struct register_summary {
  std::uint64_t words = 0;
  double largest = 0;
  double squares = 0;

  double rms() const { return words > 0 ? std::sqrt(squares / static_cast<double>(words)) : 0; }

  // Components of a golden and an ideal vector in format F.
  template <class F, int N>
  void add(glm::vec<N, double> const& golden, glm::vec<N, double> const& ideal) {
    for (int i = 0; i < N; ++i) {
      const double error = std::abs(golden[i] - ideal[i]) / range_of<F>::lsb;
      ++words;
      largest = std::max(largest, error);
      squares += error * error;
    }
  }
};

struct redecision_summary {
  std::uint64_t edges = 0, splits = 0, places = 0, middles_moved = 0;
  test_summary vt, ct, nt, sht, pt, ht;
  register_summary p, u, n, t, displaced_n, displaced_p, screen;

  void add(edge_trace const& e, redecision const& r) {
    ++edges;
    splits += r.split != e.split ? 1 : 0;
    places += e.pt.evaluated && r.k != e.k ? 1 : 0;
    middles_moved += e.sht.evaluated && r.middle_moved ? 1 : 0;
    vt.add(r.vt);
    ct.add(r.ct);
    nt.add(r.nt);
    sht.add(r.sht);
    pt.add(r.pt);
    ht.add(r.ht);
    const bool stopped = (e.vt.evaluated && !e.vt.value) || (e.ct.evaluated && !e.ct.value);
    if (stopped) return;
    p.add<formats::position>(e.m.p, r.m.p);
    u.add<formats::coordinate>(e.m.u, r.m.u);
    n.add<formats::unit>(e.m.n, r.m.n);
    t.add<formats::unit>(e.m.t, r.m.t);
    displaced_n.add<formats::unit>(e.m.displaced_n, r.m.displaced_n);
    if (!e.split) return;
    displaced_p.add<formats::position>(e.m.displaced_p, r.m.displaced_p);
    if (!e.m.behind && !r.m.behind) screen.add<formats::screen>(e.m.screen, r.m.screen);
  }

  // visitor(name, test_summary) and visitor(name, register_summary), in a fixed order.
  template <class Visitor>
  void each_test(Visitor&& visitor) const {
    visitor("vt", vt);
    visitor("ct", ct);
    visitor("nt", nt);
    visitor("sht", sht);
    visitor("pt", pt);
    visitor("ht", ht);
  }
  template <class Visitor>
  void each_register(Visitor&& visitor) const {
    visitor("p", p);
    visitor("u", u);
    visitor("n", n);
    visitor("t", t);
    visitor("displaced_n", displaced_n);
    visitor("displaced_p", displaced_p);
    visitor("screen", screen);
  }
};

}  // namespace golden
}  // namespace relievo
