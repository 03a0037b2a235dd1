// d_max_of: the entry point gives the words of the unit.
#include <vector>

#include "tests/support/shapes.hpp"
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

struct vector {
  hls::d_max_of_in in;
  hls::map_regs map;
  hls::displace_regs regs;
  RELIEVO_FIELDS(in, map, regs)
};

TEST(top_d_max_of, equals_the_unit) {
  generator words("levels");
  std::vector<std::uint16_t> maximum, minimum;
  for (int i = 0; i < 3000; ++i) {
    maximum.push_back(static_cast<std::uint16_t>(words.below(65536)));
    minimum.push_back(static_cast<std::uint16_t>(words.below(65536)));
  }
  for_vectors<vector>(
      [](vector& v, generator& g) {
        size_within(v.map.width, 40, g);
        size_within(v.map.height, 40, g);
        coordinates_within(v.in.low, v.map, g);
        coordinates_within(v.in.high, v.map, g);
        for (int axis = 0; axis < 2; ++axis)
          if (v.in.high[axis] < v.in.low[axis]) std::swap(v.in.high[axis], v.in.low[axis]);
      },
      [&](vector const& v) {
        const auto got = through<hls::d_max_of_out>(v.in, [&](auto& in, auto& out) {
          relievo_d_max_of(in, hls::pack(v.map), hls::pack(v.regs), maximum.data(), minimum.data(), out);
        });
        return same_words(got, hls::d_max_of(v.in, v.map, v.regs, {maximum.data()}, {minimum.data()}));
      },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
