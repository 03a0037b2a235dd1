// Error: closed forms on planes, ramps and single peaks, the distance against every triangle, the uniform grid.
#include "tb/analysis/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "tb/analysis/closest_point.hpp"
#include "tb/analysis/error_distance.hpp"

namespace relievo::test {
namespace {

using tb::base_corners;
using tb::surface;

struct map_data {
  std::vector<std::uint16_t> texels;
  tb::height_map map;
  map_data(int width, int height) : texels(static_cast<std::size_t>(width * height), 0) {
    map.width = width;
    map.height = height;
    map.scale = 0.5 / 65535;
    map.texels = texels.data();
  }
  map_data(map_data const&) = delete;
  map_data& operator=(map_data const&) = delete;
  std::uint16_t& at(int x, int y) {
    return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(x)];
  }
};

// A rectangle in z = 0, one texel 1/8 wide.
std::vector<base_corners> rectangle(double w, double h) {
  const auto at = [](double x, double y) { return tb::base_corner{{x / 8, y / 8, 0}, {0, 0, 1}, {x, y}}; };
  return {{at(0, 0), at(w, 0), at(w, h)}, {at(0, 0), at(w, h), at(0, h)}};
}

// Cells of the given size over the rectangle, heights from a function of U.
template <class Height>
surface grid(int w, int h, int cell, Height&& height) {
  surface s;
  const auto at = [&](int x, int y) { return tb::surface_vertex{{x / 8.0, y / 8.0, height(x, y)}, {0, 0, 1}, {x, y}}; };
  for (int y = 0; y < h; y += cell) {
    for (int x = 0; x < w; x += cell) {
      s.push_back({{at(x, y), at(x + cell, y), at(x + cell, y + cell)}, 0});
      s.push_back({{at(x, y), at(x + cell, y + cell), at(x, y + cell)}, 1});
    }
  }
  return s;
}

TEST(error, plane_under_a_constant_map_is_exact) {
  map_data m(9, 9);
  std::fill(m.texels.begin(), m.texels.end(), std::uint16_t{1000});
  m.map.bias = 0.25;
  const double height = 0.25 + 1000 * m.map.scale;
  const auto r = tb::measure_error(grid(8, 8, 8, [&](int, int) { return height; }), rectangle(8, 8), m.map);
  EXPECT_TRUE(r.along_normal);
  EXPECT_EQ(r.samples, 81u);
  EXPECT_EQ(r.uncovered, 0u);
  EXPECT_LT(r.world.max, 1e-15);
}

TEST(error, ramp_has_none_however_coarse) {
  map_data m(17, 9);
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 17; ++x) m.at(x, y) = static_cast<std::uint16_t>(100 * x + 7 * y);
  }
  const auto r = tb::measure_error(grid(16, 8, 8, [&](int x, int y) { return m.at(x, y) * m.map.scale; }), rectangle(16, 8), m.map);
  EXPECT_EQ(r.samples, 17u * 9u);
  EXPECT_LT(r.world.max, 1e-15);
}

TEST(error, single_peak_missed_and_met) {
  map_data m(9, 9);
  m.at(3, 5) = 65535;
  m.map.range_low = 236;
  m.map.range_high = 1076;
  const auto missed = tb::measure_error(grid(8, 8, 8, [](int, int) { return 0.0; }), rectangle(8, 8), m.map);
  EXPECT_DOUBLE_EQ(missed.world.max, 0.5);
  EXPECT_DOUBLE_EQ(missed.world.rms, 0.5 / 9);
  EXPECT_DOUBLE_EQ(missed.world.mean, 0.5 / 81);
  EXPECT_DOUBLE_EQ(missed.in_samples.max, 65535);
  EXPECT_DOUBLE_EQ(missed.physical.max, 840);
  EXPECT_EQ(missed.worst_x, 3);
  EXPECT_EQ(missed.worst_y, 5);
  const auto met = tb::measure_error(grid(8, 8, 1, [&](int x, int y) { return m.at(x, y) * m.map.scale; }), rectangle(8, 8), m.map);
  EXPECT_LT(met.world.max, 1e-15);
}

TEST(error, tilted_plane_is_measured_along_its_normal) {
  map_data m(9, 9);
  m.at(4, 4) = 65535;
  const glm::dvec3 n(0.6, 0.0, 0.8);
  const auto lift = [&](glm::dvec3 const& p) { return glm::dvec3(p.x * 0.8, p.y, -p.x * 0.6) + p.z * n; };
  auto s = grid(8, 8, 8, [](int, int) { return 0.125; });
  for (auto& t : s) {
    for (auto& v : t.v) v.p = lift(v.p);
  }
  auto base = rectangle(8, 8);
  for (auto& t : base) {
    for (auto& v : t) {
      v.p = lift(v.p);
      v.n = n;
    }
  }
  const auto r = tb::measure_error(s, base, m.map);
  EXPECT_TRUE(r.along_normal);
  EXPECT_NEAR(r.world.max, 0.375, 1e-14);
  EXPECT_EQ(r.worst_x, 4);
}

TEST(error, hole_is_counted_not_measured) {
  map_data m(9, 9);
  auto s = grid(8, 8, 4, [](int, int) { return 0.0; });
  s.erase(s.begin() + 2);  // U (4, 0) (8, 0) (8, 4): its samples but those on edges of neighbours
  const auto r = tb::measure_error(s, rectangle(8, 8), m.map);
  EXPECT_EQ(r.samples + r.uncovered, 81u);
  EXPECT_EQ(r.uncovered, 15u - 5u) << "15 samples, less the edge that a neighbour covers";
}

TEST(error, wrapped_axes_measure_each_sample_once) {
  map_data m(8, 8);
  m.map.wrap_u = m.map.wrap_v = true;
  m.at(0, 0) = 65535;
  const auto height = [&](int x, int y) { return m.at(x % 8, y % 8) * m.map.scale; };
  const auto r = tb::measure_error(grid(8, 8, 1, height), rectangle(8, 8), m.map);
  EXPECT_EQ(r.samples, 64u);
  EXPECT_LT(r.world.max, 1e-15);
}

TEST(error, mirrored_texture_coordinates) {
  map_data m(9, 9);
  m.at(2, 6) = 65535;
  auto s = grid(8, 8, 1, [&](int x, int y) { return m.at(x, y) * m.map.scale; });
  auto base = rectangle(8, 8);
  for (auto& t : s) {
    for (auto& v : t.v) v.p.x = -v.p.x;
  }
  for (auto& t : base) {
    for (auto& v : t) v.p.x = -v.p.x;
  }
  const auto r = tb::measure_error(s, base, m.map);
  EXPECT_EQ(r.samples, 81u);
  EXPECT_LT(r.world.max, 1e-15);
}

TEST(error, bent_base_is_measured_by_distance) {
  map_data m(9, 9);
  m.at(4, 4) = 65535;
  auto base = rectangle(8, 8);
  base[1][2].p.z = 1e-2;
  EXPECT_FALSE(tb::measures_along_normal(base));
  auto flat = rectangle(8, 8);
  EXPECT_TRUE(tb::measures_along_normal(flat));
  // The same flat scene both ways: a flat mesh, so the distance of the one peak is its height.
  const auto s = grid(8, 8, 4, [](int, int) { return 0.0; });
  const auto r = tb::measure_distance(s, flat, m.map);
  EXPECT_EQ(r.samples, 81u);
  EXPECT_DOUBLE_EQ(r.world.max, 0.5);
  EXPECT_DOUBLE_EQ(r.world.mean, 0.5 / 81);
}

TEST(error, distance_equals_a_search_over_all_triangles) {
  map_data m(33, 33);
  std::mt19937 random(20240611);
  std::uniform_real_distribution<double> spread(-0.2, 0.2);
  for (auto& t : m.texels) t = static_cast<std::uint16_t>(random() & 0xffffu);
  std::vector<double> heights;
  heights.reserve(33 * 33);
  for (int i = 0; i < 33 * 33; ++i) heights.push_back(spread(random));
  const auto s = grid(32, 32, 2, [&](int x, int y) { return heights[33 * static_cast<std::size_t>(y) + static_cast<std::size_t>(x)]; });
  auto base = rectangle(32, 32);
  for (auto& t : base) {
    for (auto& v : t) v.n = glm::normalize(glm::dvec3(v.u.x - 16, v.u.y - 16, 40));
  }
  const auto r = tb::measure_error(s, base, m.map);
  EXPECT_FALSE(r.along_normal);
  double max = 0.0;
  double sum = 0.0;
  for (int y = 0; y < 33; ++y) {
    for (int x = 0; x < 33; ++x) {
      auto const& t = base[x >= y ? 0 : 1];
      // Weights of (x, y) in the half it lies in.
      const double wx = x / 32.0;
      const double wy = y / 32.0;
      const glm::dvec3 w = x >= y ? glm::dvec3(1 - wx, wx - wy, wy) : glm::dvec3(1 - wy, wx, wy - wx);
      const glm::dvec3 n = glm::normalize(w.x * t[0].n + w.y * t[1].n + w.z * t[2].n);
      const glm::dvec3 p = w.x * t[0].p + w.y * t[1].p + w.z * t[2].p + m.at(x, y) * m.map.scale * n;
      double best = 1e30;
      for (auto const& f : s) best = std::min(best, tb::squared_distance_to_triangle(p, f.v[0].p, f.v[1].p, f.v[2].p));
      max = std::max(max, std::sqrt(best));
      sum += std::sqrt(best);
    }
  }
  EXPECT_EQ(r.samples, 33u * 33u);
  EXPECT_NEAR(r.world.max, max, 1e-12);
  EXPECT_NEAR(r.world.mean, sum / (33 * 33), 1e-12);
}

TEST(error, charts_that_share_the_map_are_measured_each) {
  map_data m(9, 9);
  auto base = rectangle(8, 8);
  auto s = grid(8, 8, 8, [](int, int) { return 0.0; });
  auto other = rectangle(8, 8);
  for (auto& t : other) {
    for (auto& v : t) v.p += glm::dvec3(2, 0, 1);
  }
  base.insert(base.end(), other.begin(), other.end());
  const auto r = tb::measure_error(s, base, m.map);
  EXPECT_EQ(r.samples, 2u * 81u);
  EXPECT_NEAR(r.world.max, std::sqrt(5.0), 1e-12) << "the second chart's far side (2, y, 1) to the only patch there is";
}

TEST(uniform_grid, ramp_is_exact_and_cells_are_square) {
  map_data m(101, 51);
  for (int y = 0; y < 51; ++y) {
    for (int x = 0; x < 101; ++x) m.at(x, y) = static_cast<std::uint16_t>(10 * x + 20 * y);
  }
  const auto r = tb::uniform_grid_error(m.map, 400);
  EXPECT_EQ(r.columns, 20);
  EXPECT_EQ(r.rows, 10);
  EXPECT_EQ(r.triangles, 400u);
  EXPECT_EQ(r.error.samples, 101u * 51u);
  EXPECT_LT(r.error.in_samples.max, 1e-9);
}

TEST(uniform_grid, equals_the_measured_mesh) {
  map_data m(33, 33);
  std::mt19937 random(7);
  for (auto& t : m.texels) t = static_cast<std::uint16_t>(random() & 0xffffu);
  const auto direct = tb::uniform_grid_error(m.map, 128);
  const auto built = tb::measure_error(grid(32, 32, 4, [&](int x, int y) { return m.at(x, y) * m.map.scale; }), rectangle(32, 32), m.map);
  EXPECT_EQ(direct.triangles, 128u);
  EXPECT_NEAR(direct.error.world.rms, built.world.rms, 1e-12);
  EXPECT_NEAR(direct.error.world.max, built.world.max, 1e-12);
}

TEST(uniform_grid, maps_of_one_sample_and_wrapped_ones) {
  map_data one(1, 1);
  one.at(0, 0) = 77;
  EXPECT_EQ(tb::uniform_grid_error(one.map, 2).error.world.max, 0.0);
  map_data turn(8, 8);
  turn.map.wrap_u = turn.map.wrap_v = true;
  for (auto& t : turn.texels) t = static_cast<std::uint16_t>(&t - turn.texels.data());
  EXPECT_LT(tb::uniform_grid_error(turn.map, 128).error.world.max, 1e-15);
}

TEST(error, json_has_the_three_units) {
  map_data m(9, 9);
  const auto json = tb::to_json(tb::measure_error(grid(8, 8, 8, [](int, int) { return 0.0; }), rectangle(8, 8), m.map));
  for (char const* unit : {"world", "samples", "physical"}) {
    for (char const* figure : {"max", "rms", "mean"}) EXPECT_TRUE(json[unit].contains(figure));
  }
}

}  // namespace
}  // namespace relievo::test
