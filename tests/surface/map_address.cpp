// map_address: hls equals golden; every coordinate of small maps against the definition; the seam; beyond a clamped border.
#include "hls/surface/map_address.hpp"

#include <gtest/gtest.h>

#include "golden/core/rounding.hpp"
#include "golden/surface/map_address.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::map_address_in, hls::map_regs>;

testing::AssertionResult hls_equals_golden(vector const& v) {
  return equal_words(hls::map_address(v.in, v.regs),
                     golden::map_address<golden::rounded>(as_golden<golden::map_address_in>(v.in), as_golden<golden::map_regs>(v.regs)));
}

TEST(map_address, hls_equals_golden) {
  for_vectors<vector>(
      [](vector& v, generator& g) {
        size_within(v.regs.width, 8192, g);
        size_within(v.regs.height, 8192, g);
        // A clamped axis stops any coordinate; a wrapped one takes those that the host lets through.
        if (v.regs.wrap_u || g.chance(2)) coordinate_within(v.in.u[0], v.regs.width, v.regs.wrap_u, g);
        if (v.regs.wrap_v || g.chance(2)) coordinate_within(v.in.u[1], v.regs.height, v.regs.wrap_v, g);
      },
      hls_equals_golden);
}

// Every word of one axis of every small map, in both modes: 2 * (1 + .. + 24) * 2048 coordinates, on u and on v.
TEST(map_address, every_coordinate_of_small_maps) {
  for (int size = 1; size <= 24; ++size)
    for (int mode = 0; mode < 4; ++mode) {
      const bool wrap = mode % 2 != 0;
      const int axis = mode / 2;
      vector v{};
      v.regs = {hls::from_raw<formats::map_size>(axis == 0 ? size : 3), hls::from_raw<formats::map_size>(axis == 1 ? size : 3),
                axis == 0 && wrap, axis == 1 && wrap};
      const std::int64_t limit = coordinate_limit(hls::from_raw<formats::map_size>(size), wrap);
      for (std::int64_t u = 0; u <= limit; ++u) {
        v.in.u[axis] = hls::from_raw<formats::coordinate>(u);
        ASSERT_TRUE(hls_equals_golden(v)) << describe(v);
        const auto out = hls::map_address(v.in, v.regs);
        auto const& cell = axis == 0 ? out.x : out.y;
        const std::int64_t floor = u / 2048;
        ASSERT_EQ(raw(cell[0]), wrap ? floor % size : std::min<std::int64_t>(floor, size - 1)) << describe(v);
        ASSERT_EQ(raw(cell[1]), wrap ? (floor + 1) % size : std::min<std::int64_t>(floor + 1, size - 1)) << describe(v);
        ASSERT_EQ(raw(out.f[axis]), u % 2048) << describe(v);
      }
    }
}

TEST(map_address, word_index_reaches_the_last_texel_of_the_largest_map) {
  const hls::map_regs map = {hls::from_raw<formats::map_size>(8192), hls::from_raw<formats::map_size>(8192), false, false};
  EXPECT_EQ(word_index(hls::from_raw<formats::map_size>(8191), hls::from_raw<formats::map_size>(8191), map), 8192u * 8192u - 1);
  EXPECT_EQ(word_index(hls::from_raw<formats::map_size>(0), hls::from_raw<formats::map_size>(1), map), 8192u);
}

}  // namespace
}  // namespace relievo::test
