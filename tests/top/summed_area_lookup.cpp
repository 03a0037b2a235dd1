// summed_area_lookup: the entry point gives the words of the unit.
#include "tests/support/map_cases.hpp"
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_summed_area_lookup, equals_the_unit) {
  for_maps([](test_map const& map, hls::map_regs const& regs) {
    generator g("rectangles");
    for (std::uint64_t i = 0; i < port_vectors() / map_case_count + 1; ++i) {
      // What a summed height test may ask for: a centre within the map, and up to half of it on either side.
      std::int64_t low[2], high[2];
      for (int axis = 0; axis < 2; ++axis) {
        const std::int64_t size = axis == 0 ? map.width() : map.height(), centre = g.between(1, size);
        const std::int64_t extent = g.between(1, size < 4 ? 2 : size / 2);
        low[axis] = centre - extent;
        high[axis] = centre + extent;
      }
      hls::summed_area_lookup_in in{};
      in.x0 = hls::from_raw<formats::bound>(low[0]);
      in.x1 = hls::from_raw<formats::bound>(high[0]);
      in.y0 = hls::from_raw<formats::bound>(low[1]);
      in.y1 = hls::from_raw<formats::bound>(high[1]);
      const auto words = through<hls::summed_area_lookup_out>(
          in, [&](auto& port_in, auto& out) { relievo_summed_area_lookup(port_in, hls::pack(regs), map.table().words, out); });
      ASSERT_TRUE(same_words(words, hls::summed_area_lookup(in, regs, map.table()))) << describe(in);
    }
  });
}

}  // namespace
}  // namespace relievo::test
