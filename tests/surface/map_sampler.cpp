// map_sampler: hls equals golden on every kind of map; against the weighted sum in integers; the seam, the texels themselves, ties.
#include "hls/surface/map_sampler.hpp"

#include <gtest/gtest.h>

#include "golden/surface/map_sampler.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

using input = hls::map_sampler_in;

// Independent of both: D = sum of four weights, 22 fractional bits, (sum + half) >> 18 as four of them stay.
std::int64_t definition(input const& in, test_map const& map, hls::map_regs const& regs) {
  std::int64_t low[2], high[2], f[2];
  for (int axis = 0; axis < 2; ++axis) {
    const std::int64_t size = axis == 0 ? map.width() : map.height(), u = raw(in.u[axis]);
    const bool wrap = axis == 0 ? regs.wrap_u : regs.wrap_v;
    f[axis] = u % 2048;
    low[axis] = wrap ? u / 2048 % size : std::min(u / 2048, size - 1);
    high[axis] = wrap ? (low[axis] + 1) % size : std::min(low[axis] + 1, size - 1);
  }
  const auto d = [&](std::int64_t x, std::int64_t y) -> std::int64_t { return map.texel(static_cast<int>(x), static_cast<int>(y)); };
  const std::int64_t sum = d(low[0], low[1]) * (2048 - f[0]) * (2048 - f[1]) + d(high[0], low[1]) * f[0] * (2048 - f[1]) +
                           d(low[0], high[1]) * (2048 - f[0]) * f[1] + d(high[0], high[1]) * f[0] * f[1];
  return (sum + (1 << 17)) >> 18;
}

testing::AssertionResult agrees(input const& in, test_map const& map, hls::map_regs const& regs) {
  const auto out = hls::map_sampler(in, regs, map.texels());
  const std::int64_t right = definition(in, map, regs);
  if (raw(out.d) != right) return testing::AssertionFailure() << "hls " << raw(out.d) << ", by definition " << right;
  return equal_words(out, golden::map_sampler<golden::rounded>(as_golden<golden::map_sampler_in>(in), as_golden<golden::map_regs>(regs),
                                                               map.golden_texels()));
}

TEST(map_sampler, hls_equals_golden_and_the_weighted_sum) {
  for_maps([](test_map const& map, hls::map_regs const& regs) {
    for_vectors<input>([&](input& in, generator& g) { coordinates_within(in.u, regs, g); },
                       [&](input const& in) { return agrees(in, map, regs); }, vector_count() / map_case_count + 1);
  });
}

// All places between four texels: 2^22 in all, in steps that leave 2^20.
TEST(map_sampler, every_other_place_of_one_cell) {
  generator g("cell");
  const test_map map(2, 2, fill::random, g);
  const hls::map_regs regs = map.regs(false, false);
  for (std::int64_t v = 0; v <= 2048; v += 2)
    for (std::int64_t u = 1; u <= 2048; u += 2) {
      const input in = {{hls::from_raw<formats::coordinate>(u), hls::from_raw<formats::coordinate>(v)}};
      ASSERT_TRUE(agrees(in, map, regs)) << describe(in);
    }
}

TEST(map_sampler, an_integer_coordinate_gives_the_texel) {
  for_maps([](test_map const& map, hls::map_regs const& regs) {
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x) {
        const input in = {{hls::from_raw<formats::coordinate>(x * 2048), hls::from_raw<formats::coordinate>(y * 2048)}};
        ASSERT_EQ(raw(hls::map_sampler(in, regs, map.texels()).d), map.texel(x, y) * 16) << x << ", " << y;
      }
  });
}

TEST(map_sampler, both_sides_of_a_seam_sample_the_same) {
  generator g("seam");
  for (const map_size size : map_sizes) {
    const test_map map(size.width, size.height, fill::random, g);
    const hls::map_regs regs = map.regs(true, true);
    for (int i = 0; i < 2000; ++i) {
      const auto u = hls::from_raw<formats::coordinate>(g.between(0, coordinate_limit(regs.width, true)));
      const auto v = hls::from_raw<formats::coordinate>(g.between(0, coordinate_limit(regs.height, true)));
      const auto zero = hls::from_raw<formats::coordinate>(0);
      const auto right = hls::from_raw<formats::coordinate>(coordinate_limit(regs.width, true));
      const auto top = hls::from_raw<formats::coordinate>(coordinate_limit(regs.height, true));
      ASSERT_EQ(raw(hls::map_sampler({{zero, v}}, regs, map.texels()).d), raw(hls::map_sampler({{right, v}}, regs, map.texels()).d));
      ASSERT_EQ(raw(hls::map_sampler({{u, zero}}, regs, map.texels()).d), raw(hls::map_sampler({{u, top}}, regs, map.texels()).d));
    }
  }
}

TEST(map_sampler, ties_round_up) {
  // Texels 0 and 1: at 1/32 the sample is half an LSB of 1/16, and rounds up; one LSB of u less rounds down.
  const std::vector<std::uint16_t> texels = {0, 1};
  const hls::map_regs regs = {hls::from_raw<formats::map_size>(2), hls::from_raw<formats::map_size>(1), false, false};
  const auto at = [&](std::int64_t u) {
    return raw(hls::map_sampler({{hls::from_raw<formats::coordinate>(u), hls::from_raw<formats::coordinate>(0)}}, regs, {texels.data()}).d);
  };
  EXPECT_EQ(at(64), 1);
  EXPECT_EQ(at(63), 0);
}

}  // namespace
}  // namespace relievo::test
