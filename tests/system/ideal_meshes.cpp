// ideal_meshes: what the paper promises of whole meshes, of the golden formulas with and without rounding: no T-vertices, every base
// triangle covered exactly, an end to the recursion, refinement down to the texel and to the pixel and no further.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <vector>

#include "golden/edge/view_test.hpp"
#include "tests/support/draw.hpp"
#include "tests/support/golden_scene.hpp"
#include "tests/support/settings.hpp"

namespace {

using namespace relievo;
using namespace relievo::golden;
using test::draw;
using test::golden_result;
using test::golden_scene;

golden_scene rough_plane(bool wrap) {
  draw d(test::seed());
  golden_scene s(61, 45, wrap,
                 [&d](int x, int y) { return 30000 + 9000 * std::sin(0.3 * x) * std::cos(0.2 * y) + d.real(0, 20000) * d.coin(); });
  s.plane(3, 3);
  s.regs.pass = {true, true, true, true, true, true, 8, false};
  s.regs.normal.threshold = rounded::at<formats::normal_threshold>(0.1);
  s.regs.summed_height.sum_threshold = 100000;
  s.regs.profile.threshold = 1000;
  s.regs.view.threshold = 6;
  s.regs.highlight.threshold = rounded::at<formats::unit>(0.99);
  return s;
}

// Every base triangle is covered once, without a flip: exact weights, exact areas.
void expect_covered(golden_result const& result, std::size_t base) {
  const auto sums = test::areas(result, base);
  for (std::size_t i = 0; i < base; ++i) EXPECT_TRUE(sums[i] == test::int128(1) << 120) << "base triangle " << i;
}

// Every displaced edge is met once in each direction, or once on the plane's border: no T-vertices, no cracks, to the bit.
void expect_watertight(golden_result const& result, glm::dvec2 const& half) {
  using edge = std::array<double, 12>;
  std::map<edge, int> edges;
  const auto key = [](out_vertex const& a, out_vertex const& b) {
    return edge{a.displaced_p.x, a.displaced_p.y, a.displaced_p.z, a.displaced_n.x, a.displaced_n.y, a.displaced_n.z,
                b.displaced_p.x, b.displaced_p.y, b.displaced_p.z, b.displaced_n.x, b.displaced_n.y, b.displaced_n.z};
  };
  for (triangle_out const& t : result.triangles)
    for (int i = 0; i < 3; ++i) ++edges[key(t.v[i], t.v[(i + 1) % 3])];
  int open = 0;
  for (triangle_out const& t : result.triangles)
    for (int i = 0; i < 3; ++i) {
      out_vertex const &a = t.v[i], &b = t.v[(i + 1) % 3];
      EXPECT_EQ(edges[key(a, b)], 1);
      const auto on_border = [&](int axis) { return std::abs(a.p[axis]) == half[axis] && a.p[axis] == b.p[axis]; };
      if (!on_border(0) && !on_border(1)) open += edges.count(key(b, a)) == 1 ? 0 : 1;
    }
  EXPECT_EQ(open, 0);
}

template <class Rounding>
void rough_scene(bool wrap, bool fifo) {
  golden_scene s = rough_plane(wrap);
  s.regs.queue.fifo = fifo;
  const golden_result result = s.run<Rounding>();
  EXPECT_GT(result.triangles.size(), 1000U);
  EXPECT_EQ(result.lasts, 1);
  EXPECT_TRUE(result.triangles.back().index >= 0);
  EXPECT_EQ(result.counts.triangles_out, result.triangles.size());
  EXPECT_LE(result.counts.queue_high_water, 3 * 8 + 4U);
  EXPECT_EQ(result.counts.triangles_out, result.counts.splits[0]);
  expect_covered(result, s.base.size());
  const glm::dvec3 corner = glm::abs(s.base[0].v[0].p);
  expect_watertight(result, {corner.x, corner.y});
}

TEST(ideal_meshes, rough_scenes_have_no_crack_and_no_flip) {
  for (const bool wrap : {false, true})
    for (const bool fifo : {false, true}) {
      rough_scene<exact>(wrap, fifo);
      rough_scene<rounded>(wrap, fifo);
    }
}

// Without vt and ct every edge splits in every generation: 4^M triangles, in a queue of 3 M + 1 entries.
TEST(ideal_meshes, uniform_refinement_quadruples_the_triangles) {
  golden_scene s = rough_plane(false);
  s.regs.pass = {};
  for (int generations = 0; generations <= 5; ++generations) {
    s.always_split(generations);
    const golden_result result = s.run<exact>();
    EXPECT_EQ(result.triangles.size(), 18U << (2 * generations));
    EXPECT_EQ(result.counts.queue_high_water, generations == 0 ? 0U : 3U * static_cast<unsigned>(generations) + 1);
    EXPECT_EQ(result.counts.splits[1] + result.counts.splits[2], 0U);
    expect_covered(result, s.base.size());
  }
}

// Section 2.5: with ct the recursion stops by itself where a midpoint shares a texel with an end.
TEST(ideal_meshes, ct_stops_at_the_resolution_of_the_map) {
  golden_scene s(17, 9, false, [](int x, int y) { return 1000 * ((x * 7 + y * 5) % 13); });
  s.plane(2, 1);
  s.always_split(15);
  s.regs.pass.use_ct = true;
  const golden_result result = s.run<exact>();
  EXPECT_GT(result.triangles.size(), 2 * 16 * 8U / 2);
  for (triangle_out const& t : result.triangles)
    for (int i = 0; i < 3; ++i) {
      const glm::dvec2 a = t.v[i].u, b = t.v[(i + 1) % 3].u;
      const glm::dvec2 middle = glm::floor(0.5 * (a + b));
      EXPECT_TRUE(middle == glm::floor(a) || middle == glm::floor(b));
    }
  expect_covered(result, s.base.size());
}

// Section 2.4: with vt no edge stays longer than the threshold, and twice the distance needs about a quarter of the triangles.
TEST(ideal_meshes, vt_refines_to_a_number_of_pixels) {
  golden_scene s(33, 33, false, [](int x, int y) { return 20000 + 300 * x + 200 * y; });
  s.plane(3, 3);
  s.always_split(15);
  s.regs.pass.use_vt = true;
  s.regs.view.threshold = 7;
  const golden_result near = s.run<exact>();
  for (triangle_out const& t : near.triangles)
    for (int i = 0; i < 3; ++i) EXPECT_LE(view_test_measure({t.v[i].screen, t.v[(i + 1) % 3].screen, false, false}), 7);
  s.regs.transform.offset_w = 6;
  const golden_result far = s.run<exact>();
  EXPECT_LT(far.triangles.size(), near.triangles.size() / 3);
  EXPECT_GT(far.triangles.size(), near.triangles.size() / 8);
}

// Decisions use the two ends alone, and exchanging them changes no bit of anything shared; k runs from the other end.
TEST(ideal_meshes, exchanging_the_ends_of_an_edge_changes_nothing) {
  draw d(test::seed());
  for (int round = 0; round < 20; ++round) {
    const test::random_map map(d, round % 2 == 0);
    for (int i = 0; i < 200; ++i) {
      const glm::dvec2 u1 = map.coordinate(d) / 3.0, u2 = map.coordinate(d) / 3.0;
      const glm::dvec3 n1 = d.direction(), n2 = d.direction();
      const double k = d.integer(0, 16);
      EXPECT_EQ((calculate_new_u<exact>({u1, u2, k}).u), (calculate_new_u<exact>({u2, u1, 16 - k}).u));
      EXPECT_EQ((calculate_new_p<exact>({n1, n2, k}).p), (calculate_new_p<exact>({n2, n1, 16 - k}).p));
      EXPECT_EQ((calculate_new_n<exact>({n1, n2, k, false}).n), (calculate_new_n<exact>({n2, n1, 16 - k, false}).n));
      const bool forward = d.coin();
      const auto there = profile_test<exact>({u1, u2, forward}, map.regs, {500}, map.texels());
      const auto back = profile_test<exact>({u2, u1, !forward}, map.regs, {500}, map.texels());
      EXPECT_EQ(there.pt, back.pt);
      EXPECT_EQ(there.k, 16 - back.k);
      const glm::dvec2 u12 = 0.5 * (u1 + u2);
      EXPECT_EQ((summed_height_measure<exact>({u1, u2, u12}, map.regs, {}, map.table()).measure),
                (summed_height_measure<exact>({u2, u1, u12}, map.regs, {}, map.table()).measure));
    }
  }
}

// Nothing to put out: one empty record says that the mesh has ended.
TEST(ideal_meshes, an_empty_or_wholly_culled_mesh_ends_with_an_empty_record) {
  golden_scene s(3, 3, false, [](int, int) { return 0; });
  EXPECT_EQ(s.run<exact>().lasts, 1);
  s.plane(2, 2);
  s.regs.pass.cull = true;
  s.regs.transform_normal.eye = {0, 0, -3};
  const golden_result result = s.run<exact>();
  EXPECT_EQ(result.lasts, 1);
  EXPECT_TRUE(result.triangles.empty());
  EXPECT_EQ(result.counts.culled, 8U);
}

}  // namespace
