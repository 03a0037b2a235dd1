// displace_vertex: hls equals golden on every kind of map, and is map_sampler then displace; a seam's two sides move alike.
#include "hls/edge/displace_vertex.hpp"

#include <gtest/gtest.h>

#include "golden/edge/displace_vertex.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::displace_vertex_in, hls::displace_regs>;

TEST(displace_vertex, hls_equals_golden) {
  for_maps([](test_map const& map, hls::map_regs const& regs) {
    const auto golden_regs = as_golden<golden::map_regs>(regs);
    for_vectors<vector>(
        [&](vector& v, generator& g) {
          coordinates_within(v.in.u, regs, g);
          if (g.chance(2)) unit_vector(v.in.n, g);
        },
        [&](vector const& v) {
          const auto out = hls::displace_vertex(v.in, regs, v.regs, map.texels());
          const auto sample = hls::map_sampler({{v.in.u[0], v.in.u[1]}}, regs, map.texels());
          const auto moved = hls::displace({{v.in.p[0], v.in.p[1], v.in.p[2]}, {v.in.n[0], v.in.n[1], v.in.n[2]}, sample.d}, v.regs);
          for (int i = 0; i < 3; ++i)
            if (raw(out.p[i]) != raw(moved.p[i])) return testing::AssertionFailure() << "not the sampler's displacement";
          return equal_words(out, golden::displace_vertex<golden::rounded>(as_golden<golden::displace_vertex_in>(v.in), golden_regs,
                                                                           as_golden<golden::displace_regs>(v.regs), map.golden_texels()));
        },
        vector_count() / map_case_count + 1);
  });
}

TEST(displace_vertex, both_sides_of_a_seam_move_alike) {
  generator g("seam");
  const test_map map(13, 5, fill::random, g);
  const hls::map_regs regs = map.regs(true, true);
  for (int i = 0; i < 20000; ++i) {
    vector v{};
    draw_vector(v, draw::uniform, g);
    coordinates_within(v.in.u, regs, g);
    v.in.u[0] = hls::from_raw<formats::coordinate>(0);
    const auto first = hls::displace_vertex(v.in, regs, v.regs, map.texels());
    v.in.u[0] = hls::from_raw<formats::coordinate>(13 * 2048);
    ASSERT_TRUE(same_words(first, hls::displace_vertex(v.in, regs, v.regs, map.texels()))) << describe(v);
  }
}

}  // namespace
}  // namespace relievo::test
