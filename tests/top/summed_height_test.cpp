// summed_height_test: the entry point gives the words of the unit.
#include "tests/support/map_cases.hpp"
#include "tests/support/shapes.hpp"
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::summed_height_test_in, hls::summed_height_test_regs>;

TEST(top_summed_height_test, equals_the_unit) {
  for_maps([](test_map const& map, hls::map_regs const& regs) {
    for_vectors<vector>(
        [&](vector& v, generator& g) {
          coordinates_within(v.in.u1, regs, g);
          coordinates_within(v.in.u2, regs, g);
          const auto middle = hls::calculate_new_u({{v.in.u1[0], v.in.u1[1]}, {v.in.u2[0], v.in.u2[1]}, hls::from_raw<formats::weight>(8)});
          for (int i = 0; i < 2; ++i) v.in.u12[i] = middle.u[i];
        },
        [&](vector const& v) {
          const auto words = through<hls::summed_height_test_out>(v.in, [&](auto& in, auto& out) {
            relievo_summed_height_test(in, hls::pack(regs), hls::pack(v.regs), map.table().words, out);
          });
          return same_words(words, hls::summed_height_test(v.in, regs, v.regs, map.table()));
        },
        port_vectors() / map_case_count + 1);
  });
}

}  // namespace
}  // namespace relievo::test
