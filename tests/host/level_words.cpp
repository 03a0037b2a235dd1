// level_words: sizes of the levels, means and extremes against their definitions by distance, and what an extreme level never lies below.
#include "tb/host/level_words.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/level_maps.hpp"

namespace relievo::test {
namespace {

// Weight of x in the cell of each texel along an axis: 1 for the nearest, half for each of two at the same distance.
std::vector<double> cells(int size, int level, bool wrap, int x) {
  std::vector<double> weights(static_cast<std::size_t>(level_size(size, level)));
  int nearest = std::numeric_limits<int>::max(), ties = 0;
  const auto all = standings(size, level, wrap);
  for (standing const& s : all) nearest = std::min(nearest, std::abs(x - s.place));
  for (standing const& s : all) ties += std::abs(x - s.place) == nearest ? 1 : 0;
  for (standing const& s : all)
    if (std::abs(x - s.place) == nearest) weights[static_cast<std::size_t>(s.texel)] += 1.0 / ties;
  return weights;
}

// The places of the map's axis, the seam from beyond included, at which a texel has a weight above 0.
std::vector<int> weighed(int size, int level, bool wrap, int texel) {
  std::vector<int> places;
  for (int x = 0; x < size + (wrap ? 1 : 0); ++x)
    for (standing const& s : standings(size, level, wrap))
      if (s.texel == texel && std::abs(x - s.place) < 1 << level) places.push_back(x % size);
  return places;
}

TEST(level_axis, sizes_are_halves_rounded_up_down_to_one) {
  for (int width : {1, 2, 3, 4, 5, 8, 403, 8191, 8192})
    for (int height : {1, 2, 7, 344, 8192}) {
      const int count = tb::levels_of(width, height);
      EXPECT_EQ(count, 1 + static_cast<int>(std::ceil(std::log2(std::max(width, height))))) << width << " x " << height;
      for (int l = 0; l < count; ++l) EXPECT_EQ((tb::level_axis{width, l, false}.texels()), level_size(width, l));
      EXPECT_EQ((tb::level_axis{width, count - 1, false}.texels()), 1);
      EXPECT_EQ((tb::level_axis{height, count - 1, true}.texels()), 1);
    }
}

TEST(level_axis, places_are_those_of_the_sampler) {
  for (int size = 1; size <= 40; ++size)
    for (int level = 0; level <= 6; ++level)
      for (bool wrap : {false, true}) {
        const tb::level_axis axis{size, level, wrap};
        std::vector<int> reached(static_cast<std::size_t>(axis.texels()));
        for (int x = 0; x < size; ++x) {
          const golden::map_regs regs{static_cast<double>(axis.texels()), 1.0, wrap, false};
          const auto right = golden::map_address<golden::exact>({{std::ldexp(x, -level), 0.0}}, regs);
          const tb::level_axis::around at = axis.place(x);
          ASSERT_EQ(static_cast<int>(at.low), right.x[0]) << size << " level " << level << " at " << x;
          ASSERT_EQ(static_cast<int>(at.high), right.x[1]) << size << " level " << level << " at " << x;
          ASSERT_EQ(std::ldexp(at.distance, -level), right.x[0] == right.x[1] ? 0.0 : right.f.x);
          for (int j = 0; j < axis.texels(); ++j)
            reached[static_cast<std::size_t>(j)] += right.x[0] == j || (right.x[1] == j && right.f.x > 0.0) ? 1 : 0;
        }
        ASSERT_EQ(axis.reached(), reached) << size << " level " << level;
      }
}

TEST(level_words, level_0_is_the_map) {
  for_level_maps("level 0", [](tb::displacement_map const& map) {
    EXPECT_EQ(tb::averaged_level(map, 0).texels, map.texels);
    EXPECT_EQ(tb::extreme_level(map, 0, tb::extreme::maximum).texels, map.texels);
    EXPECT_EQ(tb::extreme_level(map, 0, tb::extreme::minimum).texels, map.texels);
  });
}

TEST(level_words, averages_are_means_over_the_cells) {
  for_level_maps("averaged", [](tb::displacement_map const& map) {
    for (int l = 0; l < tb::levels_of(map.width, map.height); ++l) {
      const tb::displacement_map made = tb::averaged_level(map, l);
      ASSERT_EQ(made.width, level_size(map.width, l));
      ASSERT_EQ(made.height, level_size(map.height, l));
      std::vector<double> sums(made.texels.size()), weights(made.texels.size());
      for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
          const auto across = cells(map.width, l, map.wrap_u, x), up = cells(map.height, l, map.wrap_v, y);
          for (std::size_t i = 0; i < sums.size(); ++i) {
            const double weight = across[i % across.size()] * up[i / across.size()];
            sums[i] += weight * map.at(x, y);
            weights[i] += weight;
          }
        }
      for (std::size_t i = 0; i < sums.size(); ++i)
        ASSERT_EQ(made.texels[i], std::floor(sums[i] / weights[i] + 0.5))
            << map.width << " x " << map.height << " level " << l << " texel " << i;
    }
  });
}

TEST(level_words, extremes_are_those_of_all_places_with_a_weight) {
  for_level_maps("extremes", [](tb::displacement_map const& map) {
    for (int l = 0; l < tb::levels_of(map.width, map.height); ++l) {
      const tb::displacement_map high = tb::extreme_level(map, l, tb::extreme::maximum),
                                 low = tb::extreme_level(map, l, tb::extreme::minimum);
      ASSERT_EQ(high.width, level_size(map.width, l));
      ASSERT_EQ(low.height, level_size(map.height, l));
      for (int j = 0; j < high.height; ++j)
        for (int i = 0; i < high.width; ++i) {
          int highest = -1, lowest = 65536;
          const std::vector<int> across = weighed(map.width, l, map.wrap_u, i);
          for (int y : weighed(map.height, l, map.wrap_v, j))
            for (int x : across) {
              highest = std::max<int>(highest, map.at(x, y));
              lowest = std::min<int>(lowest, map.at(x, y));
            }
          ASSERT_EQ(high.at(i, j), highest) << map.width << " x " << map.height << " level " << l << " texel " << i << ", " << j;
          ASSERT_EQ(low.at(i, j), lowest) << map.width << " x " << map.height << " level " << l << " texel " << i << ", " << j;
        }
    }
  });
}

// Up to the seam seen from beyond; and coarser levels lie outside finer ones, where no seam is cut short.
TEST(level_words, extreme_levels_enclose_the_map) {
  for_level_maps("enclose", [](tb::displacement_map const& map) {
    std::vector<std::uint16_t> finer_high = map.texels, finer_low = map.texels;
    for (int l = 1; l < tb::levels_of(map.width, map.height); ++l) {
      const auto high = tb::extreme_level(map, l, tb::extreme::maximum).texels,
                 low = tb::extreme_level(map, l, tb::extreme::minimum).texels;
      for (int y = 0; y <= map.height - (map.wrap_v ? 0 : 1); ++y)
        for (int x = 0; x <= map.width - (map.wrap_u ? 0 : 1); ++x) {
          const double above = level_at(map, l, x, y, high), below = level_at(map, l, x, y, low);
          const int texel = map.at(x % map.width, y % map.height);
          ASSERT_TRUE(below <= texel && texel <= above) << map.width << " x " << map.height << " level " << l << " at " << x << ", " << y;
          if (x == map.width || y == map.height || (map.wrap_u && map.width >> l << l != map.width) ||
              (map.wrap_v && map.height >> l << l != map.height))
            continue;
          ASSERT_LE(level_at(map, l - 1, x, y, finer_high), above + 1e-9) << "level " << l << " at " << x << ", " << y;
          ASSERT_GE(level_at(map, l - 1, x, y, finer_low), below - 1e-9) << "level " << l << " at " << x << ", " << y;
        }
      finer_high = high;
      finer_low = low;
    }
  });
}

// Their sum takes more than 32 bits.
TEST(level_words, many_high_texels_have_their_mean) {
  tb::displacement_map map;
  map.width = map.height = 300;
  map.wrap_u = true;
  map.texels.assign(std::size_t(300) * 300, 65535);
  EXPECT_EQ(tb::averaged_level(map, 9).texels, std::vector<std::uint16_t>{65535});
}

}  // namespace
}  // namespace relievo::test
