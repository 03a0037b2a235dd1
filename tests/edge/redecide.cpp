// redecide: on golden's own records the ideal measures stay within the derived bounds, and the two models decide differently only
// inside them. Whole rough scenes, every test on; and the same check must refuse a decision that no rounding explains.
#include <gtest/gtest.h>

#include "golden/edge/redecision_summary.hpp"
#include "tests/support/draw.hpp"
#include "tests/support/golden_scene.hpp"
#include "tests/support/settings.hpp"

namespace {

using namespace relievo;
using namespace relievo::golden;
using test::golden_scene;

// Normals and tangents of a dome over the plane: new ones are averaged and normalised on the way.
void curve(golden_scene& s) {
  for (triangle& t : s.base)
    for (vertex& v : t.v) {
      const glm::dvec3 n = glm::normalize(glm::dvec3(0.9 * v.p.x, 0.9 * v.p.y, 1));
      v.n = test::draw::to_unit(n);
      v.t = test::draw::to_unit(glm::normalize(glm::dvec3(1, 0, 0) - n * n.x));
    }
}

golden_scene rough(bool wrap, bool average, bool use_pt, bool curved) {
  test::draw d(test::seed());
  golden_scene s(101, 77, wrap, [&d](int x, int y) { return 30000 + 15000 * std::sin(0.12 * x) * std::cos(0.17 * y) + d.real(0, 9000); });
  s.plane(3, 2);
  if (curved) curve(s);
  s.regs.pass = {true, true, use_pt, true, true, true, 9, false};
  s.regs.normal.threshold = rounded::at<formats::normal_threshold>(0.1);
  s.regs.summed_height = {average, 50000, 800};
  s.regs.profile.threshold = 900;
  s.regs.view.threshold = 3;
  s.regs.highlight = {{0, rounded::at<formats::unit>(0.6), rounded::at<formats::unit>(0.8)}, rounded::at<formats::unit>(0.97)};
  return s;
}

void expect_within(char const* name, test_redecision const& t, edge_trace const& e) {
  if (!t.compared) return;
  EXPECT_LE(std::abs(t.golden_measure - t.ideal_measure), t.bound) << name << " of base triangle " << e.index << ", path " << e.path;
  EXPECT_TRUE(t.explained()) << name << ": margin " << t.margin << ", bound " << t.bound;
}

class rough_scenes : public testing::TestWithParam<int> {};

TEST_P(rough_scenes, stay_within_the_bounds_of_every_test) {
  const golden_scene s = rough(GetParam() & 1, GetParam() & 2, GetParam() & 4, GetParam() & 8);
  const redecide again(s.regs, s.memories());
  redecision_summary summary;
  s.run<rounded>([&](edge_trace const& e) {
    const redecision r = again(e);
    expect_within("vt", r.vt, e);
    expect_within("ct", r.ct, e);
    expect_within("nt", r.nt, e);
    expect_within("sht", r.sht, e);
    expect_within("pt", r.pt, e);
    expect_within("ht", r.ht, e);
    summary.add(e, r);
  });
  EXPECT_GT(summary.edges, 1000U);
  summary.each_test([](char const* name, test_summary const& t) {
    std::printf("%-4s %6llu compared, %llu differ, change %.3g within %.3g\n", name, static_cast<unsigned long long>(t.compared),
                static_cast<unsigned long long>(t.differing), t.largest_change, t.largest_bound);
    EXPECT_EQ(t.unexplained, 0U) << name;
  });
  EXPECT_EQ(summary.vt.differing, 0U);
  EXPECT_LE(summary.p.largest, 0.5);
  EXPECT_LE(summary.u.largest, 0.5);
}

INSTANTIATE_TEST_SUITE_P(redecide, rough_scenes, testing::Range(0, 16));

TEST(redecide, the_ideal_models_own_decisions_stand) {
  const golden_scene s = rough(false, false, true, true);
  const redecide again(s.regs, s.memories());
  s.run<exact>([&](edge_trace const& e) {
    const redecision r = again(e);
    EXPECT_EQ(r.split, e.split);
    EXPECT_EQ(r.k, e.k);
    if (e.nt.evaluated) {
      EXPECT_EQ(r.m.displaced_n, e.m.displaced_n);
    }
  });
}

TEST(redecide, a_decision_that_no_rounding_explains_is_seen) {
  const golden_scene s = rough(false, false, true, true);
  const redecide again(s.regs, s.memories());
  redecision_summary summary;
  std::uint64_t flipped = 0;
  s.run<rounded>([&](edge_trace const& e) {
    const redecision r = again(e);
    if (!r.nt.compared || r.nt.margin <= r.nt.bound || r.nt.differs()) return;
    edge_trace wrong = e;
    wrong.nt.value = !wrong.nt.value;
    ++flipped;
    summary.add(wrong, again(wrong));
  });
  EXPECT_GT(flipped, 100U);
  EXPECT_EQ(summary.nt.unexplained, flipped);
}

}  // namespace
