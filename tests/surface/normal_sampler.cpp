// normal_sampler: hls equals golden on every kind of map; a texel's own normal at its place, components never mixed; the seam.
#include "hls/surface/normal_sampler.hpp"

#include <gtest/gtest.h>

#include "golden/surface/normal_sampler.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

using input = hls::normal_sampler_in;

TEST(normal_sampler, hls_equals_golden) {
  for_maps([](test_map const& map, hls::map_regs const& regs) {
    const auto golden_regs = as_golden<golden::map_regs>(regs);
    for_vectors<input>([&](input& in, generator& g) { coordinates_within(in.u, regs, g); },
                       [&](input const& in) {
                         return equal_words(hls::normal_sampler(in, regs, map.normals()),
                                            golden::normal_sampler<golden::rounded>(as_golden<golden::normal_sampler_in>(in), golden_regs,
                                                                                    map.golden_normals()));
                       },
                       vector_count() / map_case_count + 1);
  });
}

TEST(normal_sampler, an_integer_coordinate_gives_the_stored_normal) {
  for_maps([](test_map const& map, hls::map_regs const& regs) {
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x) {
        const input in = {{hls::from_raw<formats::coordinate>(x * 2048), hls::from_raw<formats::coordinate>(y * 2048)}};
        const auto out = hls::normal_sampler(in, regs, map.normals());
        const std::uint64_t word = map.normals().words[y * map.width() + x];
        for (int i = 0; i < 3; ++i) ASSERT_EQ(raw(out.n[i]), raw(hls::unpack_normal(word, i))) << x << ", " << y << ", component " << i;
      }
  });
}

TEST(normal_sampler, both_sides_of_a_seam_sample_the_same) {
  generator g("seam");
  const test_map map(13, 5, fill::random, g);
  const hls::map_regs regs = map.regs(true, true);
  const auto right = hls::from_raw<formats::coordinate>(13 * 2048);
  for (std::int64_t v = 0; v <= 5 * 2048; v += 7) {
    const auto row = hls::from_raw<formats::coordinate>(v);
    const auto a = hls::normal_sampler({{hls::from_raw<formats::coordinate>(0), row}}, regs, map.normals());
    ASSERT_TRUE(same_words(a, hls::normal_sampler({{right, row}}, regs, map.normals()))) << v;
  }
}

// A negative half LSB rounds towards the top, per component.
TEST(normal_sampler, ties_round_up_on_either_side_of_zero) {
  const hls::fixed<formats::unit> zero[3] = {}, up[3] = {hls::from_raw<formats::unit>(1), hls::from_raw<formats::unit>(-1),
                                                         hls::from_raw<formats::unit>(3)};
  const std::vector<std::uint64_t> words = {hls::pack_normal(zero), hls::pack_normal(up)};
  const hls::map_regs regs = {hls::from_raw<formats::map_size>(2), hls::from_raw<formats::map_size>(1), false, false};
  const auto out =
      hls::normal_sampler({{hls::from_raw<formats::coordinate>(1024), hls::from_raw<formats::coordinate>(0)}}, regs, {words.data()});
  EXPECT_EQ(raw(out.n[0]), 1);
  EXPECT_EQ(raw(out.n[1]), 0);
  EXPECT_EQ(raw(out.n[2]), 2);
}

}  // namespace
}  // namespace relievo::test
