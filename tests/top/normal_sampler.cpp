// normal_sampler: the entry point gives the words of the unit.
#include "tests/support/map_cases.hpp"
#include "tests/support/shapes.hpp"
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

using vector = hls::normal_sampler_in;

TEST(top_normal_sampler, equals_the_unit) {
  for_maps([](test_map const& map, hls::map_regs const& regs) {
    for_vectors<vector>([&](vector& v, generator& g) { coordinates_within(v.u, regs, g); },
                        [&](vector const& v) {
                          const auto words = through<hls::normal_sampler_out>(
                              v, [&](auto& in, auto& out) { relievo_normal_sampler(in, hls::pack(regs), map.normals().words, out); });
                          return same_words(words, hls::normal_sampler(v, regs, map.normals()));
                        },
                        port_vectors() / map_case_count + 1);
  });
}

}  // namespace
}  // namespace relievo::test
