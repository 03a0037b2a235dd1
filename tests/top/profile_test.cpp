// profile_test: the entry point gives the words of the unit.
#include "tests/support/map_cases.hpp"
#include "tests/support/shapes.hpp"
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::profile_test_in, hls::profile_test_regs>;

TEST(top_profile_test, equals_the_unit) {
  for_maps([](test_map const& map, hls::map_regs const& regs) {
    for_vectors<vector>(
        [&](vector& v, generator& g) {
          coordinates_within(v.in.u1, regs, g);
          coordinates_within(v.in.u2, regs, g);
        },
        [&](vector const& v) {
          const auto words = through<hls::profile_test_out>(
              v.in, [&](auto& in, auto& out) { relievo_profile_test(in, hls::pack(regs), hls::pack(v.regs), map.texels().words, out); });
          return same_words(words, hls::profile_test(v.in, regs, v.regs, map.texels()));
        },
        port_vectors() / map_case_count + 1);
  });
}

}  // namespace
}  // namespace relievo::test
