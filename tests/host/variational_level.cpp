// variational_level: volume and derivatives against their definitions; the volume falls and never rises; what cannot get better stays.
#include "tb/host/variational_level.hpp"

#include <gtest/gtest.h>

#include "tests/support/level_maps.hpp"

namespace relievo::test {
namespace {

constexpr int plenty = 2000;

tb::fitted_level fit(tb::displacement_map const& map, int level, int passes = plenty) {
  return tb::variational_level(map, level, passes, [] {});
}

// A surface of waves and noise, so that coarse levels have something to follow.
tb::displacement_map terrain(int width, int height, int wrap) {
  generator g("terrain");
  tb::displacement_map map = level_map(width, height, wrap, 9, g);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::uint16_t& texel = map.texels[static_cast<std::size_t>(y * width + x)];
      texel = static_cast<std::uint16_t>(texel + 30000 + 12000 * std::sin(0.3 * x) * std::cos(0.2 * y) +
                                         8000 * std::fabs(std::sin(0.11 * x * y)));
    }
  return map;
}

TEST(difference_volume, volume_and_derivatives_are_those_of_the_definition) {
  generator g("heights");
  for_level_maps("slopes", [&](tb::displacement_map const& map) {
    for (int l = 0; l < tb::levels_of(map.width, map.height); ++l) {
      const auto words = tb::averaged_level(map, l).texels;
      std::vector<double> heights(words.begin(), words.end()), slopes;
      // Some on the map itself, where the quotient turns.
      for (double& h : heights)
        if (!g.chance(3)) h += static_cast<double>(g.between(-3000, 3000)) / 7.0;
      const tb::difference_volume volume(map, l);
      const double eps = g.chance(2) ? 0.5 : 40.0, now = volume_by_definition(map, l, heights);
      ASSERT_NEAR(volume.of(heights), now, 1e-9 * (1.0 + now));
      ASSERT_NEAR(volume.with_slopes(heights, eps, slopes), now, 1e-9 * (1.0 + now));
      ASSERT_EQ(slopes.size(), heights.size());
      for (std::size_t i = 0; i < heights.size(); ++i) {
        std::vector<double> unit(heights.size());
        unit[i] = 1.0;
        int reached = 0;
        for (int y = 0; y < map.height; ++y)
          for (int x = 0; x < map.width; ++x) reached += level_at(map, l, x, y, unit) > 0.0 ? 1 : 0;
        std::vector<double> raised = heights;
        raised[i] += eps;
        const double quotient = (volume_by_definition(map, l, raised) - now) / (eps * reached);
        ASSERT_NEAR(slopes[i], quotient, 1e-6) << map.width << " x " << map.height << " level " << l << " texel " << i;
      }
    }
  });
}

TEST(variational_level, volume_never_above_the_averaged_level) {
  int lower = 0;
  for_level_maps("never above", [&](tb::displacement_map const& map) {
    for (int l = 1; l < tb::levels_of(map.width, map.height); ++l) {
      const tb::displacement_map averaged = tb::averaged_level(map, l);
      for (int passes : {1, 3, plenty}) {
        const tb::fitted_level made = fit(map, l, passes);
        ASSERT_LE(made.passes, passes);
        ASSERT_EQ(made.level.width, averaged.width);
        ASSERT_EQ(made.level.texels.size(), averaged.texels.size());
        ASSERT_NEAR(made.before, volume_by_definition(map, l, averaged.texels), 1e-9 * (1.0 + made.before));
        ASSERT_NEAR(made.after, volume_by_definition(map, l, made.level.texels), 1e-9 * (1.0 + made.before));
        ASSERT_LE(made.after, made.before) << map.width << " x " << map.height << " level " << l;
        lower += made.after < made.before ? 1 : 0;
      }
    }
  });
  EXPECT_GT(lower, 200);
}

// On a relief of a few words the rounding at the end may take back more than was won: this one's level comes to 5.0 from 4.5.
TEST(variational_level, rounding_to_words_never_raises_the_volume) {
  tb::displacement_map map;
  map.width = 5;
  map.height = 1;
  map.texels = {0, 2, 2, 3, 1};
  const tb::fitted_level made = fit(map, 2);
  EXPECT_EQ(made.before, 4.5);
  EXPECT_GT(made.passes, 3);
  EXPECT_LE(volume_by_definition(map, 2, made.level.texels), 4.5);
}

TEST(variational_level, volume_falls_on_a_rough_map) {
  for (int wrap = 0; wrap < 4; ++wrap) {
    const tb::displacement_map map = terrain(67, 48, wrap);
    const double bounds[] = {0.9, 0.9, 0.85};
    for (int l = 1; l <= 3; ++l) {
      const tb::fitted_level made = fit(map, l);
      EXPECT_LT(made.after, bounds[l - 1] * made.before) << "wrap " << wrap << " level " << l;
      EXPECT_LT(made.passes, plenty);
      EXPECT_LT(made.after, fit(map, l, 2).after);
    }
  }
}

// A map half as high comes out as well as the whole one: the unit of eps and lambda follows the map.
TEST(variational_level, how_high_the_map_is_does_not_matter) {
  const tb::displacement_map map = terrain(40, 33, 0);
  tb::displacement_map low = map;
  for (std::uint16_t& texel : low.texels) texel = static_cast<std::uint16_t>(texel / 2 * 2);
  tb::displacement_map half = low;
  for (std::uint16_t& texel : half.texels) texel = static_cast<std::uint16_t>(texel / 2);
  const tb::fitted_level whole = fit(low, 2), small = fit(half, 2);
  EXPECT_NEAR(whole.after / whole.before, small.after / small.before, 1e-3);
}

TEST(variational_level, a_constant_map_is_a_fixed_point) {
  for (int wrap = 0; wrap < 4; ++wrap)
    for (int word : {0, 1, 32768, 65535}) {
      generator g("constant");
      tb::displacement_map map = level_map(13, 9, wrap, 16, g);
      map.texels.assign(map.texels.size(), static_cast<std::uint16_t>(word));
      for (int l = 1; l < tb::levels_of(map.width, map.height); ++l) {
        const tb::fitted_level made = fit(map, l);
        EXPECT_EQ(made.level.texels, std::vector<std::uint16_t>(made.level.texels.size(), static_cast<std::uint16_t>(word)));
        EXPECT_EQ(made.after, 0.0);
      }
    }
}

// A peak on full height and a pit on height 0 push the level out of the words' range.
TEST(variational_level, heights_stay_words) {
  generator g("extremes");
  tb::displacement_map map = level_map(33, 33, 0, 16, g);
  for (std::size_t i = 0; i < map.texels.size(); ++i) map.texels[i] = (i / 5 % 2 == 0) ? 0xffff : 0;
  for (int l = 1; l <= 3; ++l) {
    const tb::fitted_level made = fit(map, l);
    EXPECT_NEAR(made.after, volume_by_definition(map, l, made.level.texels), 1e-9 * made.before);
    EXPECT_LE(made.after, made.before);
  }
}

}  // namespace
}  // namespace relievo::test
