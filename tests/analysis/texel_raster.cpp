// The raster meets every texel centre of a tiled square, borders included, and its weights give the centre back.
#include "tb/analysis/texel_raster.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace relievo::test {
namespace {

TEST(texel_raster, random_fans_leave_no_centre_out) {
  std::mt19937 random(1);
  constexpr int side = 24;
  for (int round = 0; round < 200; ++round) {
    const auto word = [&] { return static_cast<double>(random() % (side * 2048 + 1)) / 2048.0; };
    const glm::dvec2 apex(word(), word());
    const double a = word();
    const double b = word();
    const std::vector<glm::dvec2> rim = {{0, 0}, {a, 0}, {side, 0}, {side, b}, {side, side}, {a, side}, {0, side}, {0, b}};
    std::vector<int> visits((side + 1) * (side + 1), 0);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const std::array<glm::dvec2, 3> t = {apex, rim[i], rim[(i + 1) % rim.size()]};
      tb::raster_texels(t, [&](int x, int y, glm::dvec3 const& w) {
        ++visits[static_cast<std::size_t>(y) * (side + 1) + static_cast<std::size_t>(x)];
        const glm::dvec2 back = w.x * t[0] + w.y * t[1] + w.z * t[2];
        EXPECT_NEAR(back.x, x, 1e-9);
        EXPECT_NEAR(back.y, y, 1e-9);
        EXPECT_GE(std::min({w.x, w.y, w.z}), 0.0);
      });
    }
    for (const int n : visits) ASSERT_GE(n, 1);
  }
}

TEST(texel_raster, agrees_with_the_definition_for_slivers_of_both_orientations) {
  std::mt19937 random(2);
  for (int round = 0; round < 2000; ++round) {
    const auto coordinate = [&](int step) { return 8176.0 + static_cast<double>(random() % (16 * 2048u)) / 2048.0 / step; };
    const std::array<glm::dvec2, 3> t = {
        {{coordinate(1), coordinate(1)}, {coordinate(1), coordinate(1)}, {coordinate(64), coordinate(64)}}};
    std::vector<std::pair<int, int>> met;
    tb::raster_texels(t, [&](int x, int y, glm::dvec3 const&) { met.emplace_back(x, y); });
    std::vector<std::pair<int, int>> expected;
    const auto exact = [](glm::dvec2 const& u) { return tb::raster_detail::to_lattice(u); };
    const auto p = exact(t[0]);
    const auto q = exact(t[1]);
    const auto r = exact(t[2]);
    const auto whole = tb::raster_detail::edge_function(p, q, r);
    for (int y = 8176; y <= 8192; ++y) {
      for (int x = 8176; x <= 8192; ++x) {
        const auto c = exact({x, y});
        const std::int64_t e[3] = {tb::raster_detail::edge_function(p, q, c), tb::raster_detail::edge_function(q, r, c),
                                   tb::raster_detail::edge_function(r, p, c)};
        const bool in = whole > 0 ? e[0] >= 0 && e[1] >= 0 && e[2] >= 0 : whole < 0 && e[0] <= 0 && e[1] <= 0 && e[2] <= 0;
        if (in) expected.emplace_back(x, y);
      }
    }
    ASSERT_EQ(met, expected);
  }
}

TEST(texel_raster, no_area_no_visit) {
  int visits = 0;
  tb::raster_texels({{{0, 0}, {4, 4}, {8, 8}}}, [&](int, int, glm::dvec3 const&) { ++visits; });
  tb::raster_texels({{{2, 2}, {2, 2}, {2, 2}}}, [&](int, int, glm::dvec3 const&) { ++visits; });
  EXPECT_EQ(visits, 0);
}

}  // namespace
}  // namespace relievo::test
