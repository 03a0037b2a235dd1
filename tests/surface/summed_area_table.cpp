// summed_area_table: hls equals golden and the sums themselves on every small map; maps back to back; modulo 2^40 on the widest map.
#include "hls/surface/summed_area_table.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "golden/surface/summed_area_table.hpp"
#include "tests/support/map_cases.hpp"

namespace relievo::test {
namespace {

hls::map_regs regs_of(int width, int height) {
  return {hls::from_raw<formats::map_size>(width), hls::from_raw<formats::map_size>(height), false, false};
}

// Streams a map through the builder and holds every word against golden and the inclusive sum.
void expect_table(hls::summed_area_table<512>& builder, test_map const& map) {
  const auto table = golden::summed_area_table(map.words().data(), map.width(), map.height());
  const hls::map_regs regs = regs_of(map.width(), map.height());
  std::vector<std::uint64_t> column(static_cast<std::size_t>(map.width()), 0);
  for (int y = 0; y < map.height(); ++y) {
    std::uint64_t sum = 0;
    for (int x = 0; x < map.width(); ++x) {
      const auto i = static_cast<std::size_t>(x);
      column[i] += static_cast<std::uint64_t>(map.texel(x, y));
      sum += column[i];
      const auto word = builder.step(hls::from_raw<formats::texel>(map.texel(x, y)), regs);
      ASSERT_EQ(static_cast<std::uint64_t>(raw(word)), sum) << x << ", " << y;
      ASSERT_EQ(sum, table[static_cast<std::size_t>(y) * column.size() + i]) << x << ", " << y;
    }
  }
}

TEST(summed_area_table, hls_equals_golden_map_after_map) {
  const auto builder = std::make_unique<hls::summed_area_table<512>>();
  for_maps([&](test_map const& map, hls::map_regs const&) { expect_table(*builder, map); });
}

TEST(summed_area_table, random_maps_a_million_texels_in_all) {
  const auto builder = std::make_unique<hls::summed_area_table<512>>();
  generator g("texels");
  for (std::uint64_t texels = 0; texels < vector_count() && !HasFailure();) {
    const int width = static_cast<int>(g.between(1, 512)), height = static_cast<int>(g.between(1, 40));
    expect_table(*builder, test_map(width, height, g.chance(4) ? fill::maximum : fill::random, g));
    texels += static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  }
}

// 2^24 maximal texels reach 2^40 - 2^24; a map 8192 wide goes beyond in its row 2048.
TEST(summed_area_table, wraps_at_2_to_the_40_on_the_widest_map) {
  const auto builder = std::make_unique<hls::summed_area_table<8192>>();
  const hls::map_regs regs = regs_of(8192, 8192);
  const std::uint64_t mask = (std::uint64_t(1) << 40) - 1;
  std::uint64_t beyond = 0;
  for (std::uint64_t y = 0; y < 2060; ++y)
    for (std::uint64_t x = 0; x < 8192; ++x) {
      const std::uint64_t sum = 65535 * (x + 1) * (y + 1);
      beyond += sum > mask ? 1 : 0;
      ASSERT_EQ(static_cast<std::uint64_t>(raw(builder->step(hls::from_raw<formats::texel>(65535), regs))), sum & mask) << x << ", " << y;
    }
  EXPECT_GT(beyond, 300u);
}

}  // namespace
}  // namespace relievo::test
