// ideal_properties: the first step of the ladder, ideal = the paper. Closed forms on constant maps, ramps, tents and a cylinder, the
// paper's figure 5, and what its equations promise (exchange of ends, watertight meshes, cancelling sums) for the golden formulas,
// without rounding and, where the promise is exact, with it.
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "golden/edge/profile_test.hpp"
#include "tests/support/draw.hpp"
#include "tests/support/golden_scene.hpp"
#include "tests/support/settings.hpp"

namespace {

using namespace relievo;
using namespace relievo::golden;
using test::draw;
using test::golden_scene;

constexpr double pi = 3.14159265358979323846;

void expect_near(glm::dvec3 const& a, glm::dvec3 const& b, double tolerance) {
  EXPECT_LE(glm::length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z << " for " << b.x << ' ' << b.y << ' ' << b.z;
}

template <class Rounding>
void constant_map(double level, bool wrap, bool average) {
  golden_scene s(33, 21, wrap, [level](int, int) { return level; });
  s.displace(rounded::at<formats::scale>(0.5 / 65535), rounded::at<formats::height>(0.125));
  s.plane(3, 3);
  s.regs.pass = {true, true, true, false, false, false, 12, false};
  s.regs.summed_height.average = average;
  const auto result = s.run<Rounding>();
  EXPECT_EQ(result.triangles.size(), 18U);
  EXPECT_EQ(result.counts.splits[0], 18U);
  const double height = Rounding::template at<formats::height>(s.regs.displace.scale * level + s.regs.displace.bias);
  for (triangle_out const& t : result.triangles)
    for (out_vertex const& v : t.v) {
      EXPECT_EQ(v.displaced_p, v.p + glm::dvec3(0, 0, height));
      EXPECT_EQ(v.displaced_n, glm::dvec3(0, 0, 1));
    }
}

// Equation 1 with a constant D; every test says no even at threshold 0, sums cancel in both modes, on both kinds of axes.
TEST(ideal_properties, a_constant_map_lifts_the_plane_and_splits_nothing) {
  for (const double level : {0.0, 1.0, 12345.0, 65535.0})
    for (const bool wrap : {false, true})
      for (const bool average : {false, true}) {
        constant_map<exact>(level, wrap, average);
        constant_map<rounded>(level, wrap, average);
      }
}

// A ramp displaces a plane into a plane: one normal, no profile.
TEST(ideal_properties, a_ramp_is_a_plane_with_the_normal_of_its_slope) {
  golden_scene s(65, 49, false, [](int x, int y) { return 500 + 100 * x + 37 * y; });
  s.displace(2.0 / 65535, 0);
  s.plane(3, 2);
  s.regs.pass = {true, false, true, false, false, false, 12, false};
  const auto result = s.run<exact>();
  EXPECT_EQ(result.triangles.size(), 12U);
  const double shift = std::ldexp(1, -static_cast<int>(s.normal_map.normal_shift));
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-s.normal_map.gradient_u * 200, -s.normal_map.gradient_v * 74, shift));
  for (triangle_out const& t : result.triangles)
    for (out_vertex const& v : t.v) {
      expect_near(v.displaced_n, normal, 1e-12);
      EXPECT_NEAR(v.displaced_p.z, s.regs.displace.scale * (500 + 100 * v.u.x + 37 * v.u.y), 1e-12);
    }
  // The same slope from the displaced points themselves; the gradient's register is the coarser of the two.
  triangle_out const& t = result.triangles[0];
  const auto across = glm::cross(t.v[1].displaced_p - t.v[0].displaced_p, t.v[2].displaced_p - t.v[0].displaced_p);
  expect_near(glm::normalize(across), normal, 1e-3);
}

// Section 5.1: P'(s D) - P grows with s; the map's normals tilt with it.
TEST(ideal_properties, the_scale_multiplies_the_displacement) {
  draw d(test::seed());
  for (int i = 0; i < 1000; ++i) {
    const displace_in in{d.words<formats::position>(-1, 1), d.unit(), d.word<formats::sample>(0, 65535)};
    const glm::dvec3 once = displace<exact>(in, {1e-5, 0}).p - in.p, twice = displace<exact>(in, {2e-5, 0}).p - in.p;
    expect_near(twice, 2.0 * once, 1e-12);
    expect_near(glm::cross(once, in.n), glm::dvec3(0), 1e-12);
  }
}

// Midpoints of chords move along the averaged normal: radius cos(half the angle) + h.
TEST(ideal_properties, a_cylinder_grows_by_its_height_along_averaged_normals) {
  golden_scene s(64, 16, true, [](int, int) { return 10000; });
  s.displace(0.25 / 10000, 0);
  s.regs.map.wrap_v = false;
  const auto at = [](int i, double z) {
    vertex v;
    const double angle = 2 * pi * i / 8;
    v.n = {std::cos(angle), std::sin(angle), 0};
    v.t = {-std::sin(angle), std::cos(angle), 0};
    v.p = {v.n.x, v.n.y, z};
    v.u = {8.0 * i, 7.5 + 7.5 * z};
    return v;
  };
  for (int i = 0; i < 8; ++i) s.add(at(i, -1), at(i + 1, -1), at(i + 1, 1));
  s.always_split(1);
  const auto result = s.run<exact>();
  EXPECT_EQ(result.triangles.size(), 32U);
  const double height = s.regs.displace.scale * 10000;
  for (triangle_out const& t : result.triangles)
    for (out_vertex const& v : t.v) {
      const double flat = std::hypot(v.p.x, v.p.y), risen = std::hypot(v.displaced_p.x, v.displaced_p.y);
      EXPECT_TRUE(std::abs(flat - 1) < 1e-12 || std::abs(flat - std::cos(pi / 8)) < 1e-12);
      EXPECT_NEAR(risen, flat + height, 1e-12);
      EXPECT_NEAR(v.displaced_n.x * v.displaced_p.y, v.displaced_n.y * v.displaced_p.x, 1e-12);
    }
}

// N_D = (0, 0, 1) leaves N alone; in an orthonormal frame N' is N_D turned into it.
TEST(ideal_properties, bump_turns_the_maps_normal_into_the_frame) {
  draw d(test::seed());
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 n = d.direction(), t = glm::normalize(glm::cross(n, d.direction())), b = glm::cross(n, t), m = d.direction();
    expect_near(bump<exact>({n, t, {0, 0, 1}}).n, n, 1e-12);
    const glm::dvec3 turned = bump<exact>({n, t, m}).n;
    expect_near({glm::dot(turned, t), glm::dot(turned, b), glm::dot(turned, n)}, m, 1e-12);
  }
}

TEST(ideal_properties, the_screen_is_a_pinholes) {
  draw d(test::seed());
  const golden_scene s(2, 2, false, [](int, int) { return 0; });
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 p = d.words<formats::position>(-2, 2);
    transform_regs twice = s.regs.transform;
    twice.row_x *= 2;
    twice.row_y *= 2;
    twice.row_w *= 2;
    twice.offset_w *= 2;
    const auto seen = transform<exact>({p}, s.regs.transform);
    EXPECT_NEAR(seen.screen.x, 200 * p.x / (3 - p.z), 1e-9);
    EXPECT_NEAR(seen.screen.y, 200 * p.y / (3 - p.z), 1e-9);
    EXPECT_LE(glm::length(transform<exact>({p}, twice).screen - seen.screen), 1e-9);
  }
  EXPECT_TRUE(transform<exact>({{0, 0, 3}}, s.regs.transform).behind);
  EXPECT_TRUE(transform<exact>({{0, 0, 5}}, s.regs.transform).behind);
}

// The sums of the definition, texel by texel: a wrapped axis repeats, a clamped one stands for its mean.
template <class Texels>
double sum_by_definition(glm::dvec2 const& u, glm::ivec2 const& e, map_regs const& map, Texels const& texels) {
  const int w = static_cast<int>(map.width), h = static_cast<int>(map.height);
  const glm::ivec2 c(glm::floor(u + 1.0));
  double sum = 0;
  int inside = 0;
  for (int y = c.y - e.y; y < c.y + e.y; ++y)
    for (int x = c.x - e.x; x < c.x + e.x; ++x) {
      if ((!map.wrap_u && (x < 0 || x >= w)) || (!map.wrap_v && (y < 0 || y >= h))) continue;
      sum += texels(((x % w) + w) % w, ((y % h) + h) % h);
      ++inside;
    }
  return sum / inside * (4.0 * e.x * e.y);
}

TEST(ideal_properties, summed_heights_are_the_sums_of_the_definition) {
  draw d(test::seed());
  for (int round = 0; round < 40; ++round) {
    const test::random_map map(d, round % 2 == 0);
    for (int i = 0; i < 50; ++i) {
      const glm::dvec2 u1 = map.coordinate(d), u2 = map.coordinate(d), u12 = 0.5 * (u1 + u2);
      const glm::ivec2 e = summed_height_extent(u1, u2, map.regs);
      const double expected = sum_by_definition(u12, 2 * e, map.regs, map.texels()) -
                              2 * (sum_by_definition(u1, e, map.regs, map.texels()) + sum_by_definition(u2, e, map.regs, map.texels()));
      const auto sides = summed_height_measure<exact>({u1, u2, u12}, map.regs, {}, map.table());
      EXPECT_NEAR(sides.measure, std::abs(expected), 1e-6);
    }
  }
}

// S12/2 = S1 + S2 on a slope, as long as the rectangles are inside and the middle's centre is the middle of the centres.
TEST(ideal_properties, summed_heights_cancel_on_a_slope) {
  draw d(test::seed());
  golden_scene s(256, 256, false, [](int x, int y) { return 1000 + 120 * x + 77 * y; });
  const table_memory table(s.table.data(), s.regs.map);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec2 middle(d.integer(110, 140), d.integer(110, 140)), half(d.integer(-60, 60), d.integer(-60, 60));
    EXPECT_EQ(summed_height_measure<rounded>({middle - half, middle + half, middle}, s.regs.map, {}, table).measure, 0);
  }
}

// One edge over 64 texels of a one-dimensional map that goes on at both ends: what the paper's tests and the profile see of it.
struct seen {
  bool nt, sht, pt;
};
template <class Formula>
seen along_one_edge(Formula&& formula) {
  golden_scene s(97, 3, false, [&formula](int x, int) { return formula(x - 16); });
  s.displace(0.25 / 65535, 0);
  vertex a, b, c;
  a.p = {-1, 0, 0};
  b.p = {1, 0, 0};
  c.p = {0, 1, 0};
  a.n = b.n = c.n = {0, 0, 1};
  a.t = b.t = c.t = {1, 0, 0};
  a.u = {16, 1};
  b.u = {80, 1};
  c.u = {48, 2};
  s.add(a, b, c);
  s.regs.pass = {true, true, true, false, false, false, 1, false};
  s.regs.normal.threshold = 0.05;
  s.regs.summed_height = {true, 0, 2000};
  s.regs.profile.threshold = 2000;
  seen result{};
  s.run<exact>([&result](edge_trace const& e) {
    if (e.edge == 0) result = {e.nt.value, e.sht.value, e.pt.value};
  });
  return result;
}

// Figure 5 (a): a hill whose foot and top are level. (b): a ripple, steep at the middle, whose averages do not change.
// And the paper's remark: a regular ripple escapes both; the profile test is there for it.
TEST(ideal_properties, figure_5_each_test_alone_misses_a_map) {
  const seen hill = along_one_edge([](int x) { return 30000 - 30000 * std::cos(2 * pi * x / 64); });
  EXPECT_FALSE(hill.nt);
  EXPECT_TRUE(hill.sht);
  const seen ripple = along_one_edge([](int x) { return 32000 + 8000 * std::sin(2 * pi * 9 * x / 64); });
  EXPECT_TRUE(ripple.nt);
  EXPECT_FALSE(ripple.sht);
  const seen regular = along_one_edge([](int x) { return 32000 + 8000 * std::cos(2 * pi * 8 * x / 64); });
  EXPECT_FALSE(regular.nt);
  EXPECT_FALSE(regular.sht);
  EXPECT_TRUE(along_one_edge([](int x) { return x < 40 ? 1000 * x : 40000 * (64 - x) / 24; }).pt);
}

// A tent's crest in the middle third is where the new vertex goes, and its height is the deviation.
TEST(ideal_properties, the_profile_finds_the_crest_of_a_tent) {
  for (int k = 6; k <= 10; ++k) {
    const int crest = 4 * k;
    const auto tent = [crest](int x, int) { return x < crest ? 40000.0 * x / crest : 40000.0 * (64 - x) / (64 - crest); };
    const map_regs map{65, 2, false, false};
    const profile_test_in in{{0, 0}, {64, 0}, true};
    EXPECT_EQ(profile_test<exact>(in, map, {39999}, tent).k, k);
    EXPECT_TRUE(profile_test<exact>(in, map, {39999}, tent).pt);
    EXPECT_FALSE(profile_test<exact>(in, map, {40000}, tent).pt);
    EXPECT_NEAR(profile_of<exact>(in, map, tent).measure(), 16 * 40000, 1e-6);
  }
}

}  // namespace
