// d_max_of (base_triangle_clip): hls equals golden; bounds every displacement of its box.
#include <gtest/gtest.h>

#include <vector>

#include "golden/sweep/base_triangle_clip.hpp"
#include "hls/surface/map_sampler.hpp"
#include "tests/support/level_maps.hpp"
#include "tests/support/pyramids.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using box = stimulus<hls::d_max_of_in, hls::displace_regs>;

box draw_box(pyramids const& map, generator& g) {
  box v{};
  draw_vector(v, draw::mixed, g);
  if (g.chance(2)) v.regs.scale = hls::from_raw<formats::scale>(g.between(-40000, 40000));
  coordinates_within(v.in.low, map.regs, g);
  coordinates_within(v.in.high, map.regs, g);
  for (int axis = 0; axis < 2; ++axis)
    if (v.in.high[axis] < v.in.low[axis]) std::swap(v.in.high[axis], v.in.low[axis]);
  return v;
}

TEST(d_max_of, hls_equals_golden_and_bounds_every_displacement_of_the_box) {
  generator g = next_generator();
  std::uint64_t tight = 0;
  for_level_maps("d_max_of", [&](tb::displacement_map const& drawn) {
    const pyramids map(drawn);
    for (std::uint64_t round = 0; round < vector_count() / 400; ++round) {
      const box v = draw_box(map, g);
      const auto out = map.at(v.in, v.regs);
      const auto read = [](std::vector<tb::displacement_map> const& levels) {
        return [&levels](int level, int x, int y) { return levels[static_cast<std::size_t>(level)].at(x, y); };
      };
      ASSERT_TRUE(equal_words(out, golden::d_max_of(as_golden<golden::d_max_of_in>(v.in), as_golden<golden::map_regs>(map.regs),
                                                    as_golden<golden::displace_regs>(v.regs), read(map.highest), read(map.lowest))))
          << describe(v);
      for (int sample = 0; sample < 4; ++sample) {
        hls::map_sampler_in at;
        for (int axis = 0; axis < 2; ++axis)
          at.u[axis] = hls::from_raw<formats::coordinate>(g.between(raw(v.in.low[axis]), raw(v.in.high[axis])));
        const auto d = hls::map_sampler(at, map.regs, {map.texels.data()}).d;
        const auto height = hls::round_to<formats::height>(v.regs.scale * d + v.regs.bias);
        ASSERT_LE(std::abs(raw(height)) + 2, raw(out.d_max)) << describe(v) << describe(at);
        tight += std::abs(raw(height)) > raw(out.d_max) / 2 ? 1 : 0;
      }
    }
  });
  EXPECT_GT(tight, vector_count() / 400);
}

}  // namespace
}  // namespace relievo::test
