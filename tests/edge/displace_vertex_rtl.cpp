// displace_vertex: the circuit equals the kernel on every kind of map under all traffic; a vertex a clock, 31 clocks and the memory's
// later.
#include "Vdisplace_vertex.h"
#include "hls/edge/displace_vertex.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/map_memories.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/stream_unit.hpp"

namespace relievo::test {
namespace {

using vector = map_stimulus<hls::displace_vertex_in, hls::displace_regs>;

std::uint64_t clocks_of(traffic const& t, test_map const& map, hls::map_regs const& regs, std::uint64_t count) {
  const auto shape = [&](vector& v, generator& g) {
    v.map = regs;
    coordinates_within(v.in.u, regs, g);
    if (g.chance(2)) unit_vector(v.in.n, g);
  };
  const auto expected = [&](vector const& v) { return hls::displace_vertex(v.in, regs, v.regs, map.texels()); };
  const auto answers = texel_answers(map);
  return stream_test<Vdisplace_vertex, vector>(t, shape, expected, {RELIEVO_MEMORY_PORT(Vdisplace_vertex, quad, quad_request, answers)},
                                               count);
}

TEST(displace_vertex, rtl_equals_hls) {
  const auto list = all_traffic();
  for_maps([&](test_map const& map, hls::map_regs const& regs) {
    for (traffic const& t : list) clocks_of(t, map, regs, rtl_vector_count() / (map_case_count * list.size()) + 1);
  });
}

TEST(displace_vertex, a_vertex_a_clock) {
  generator g("rate");
  const test_map map(13, 37, fill::random, g);
  for (const std::int64_t latency : {1, 60})
    EXPECT_EQ(clocks_of({0, 0, latency, latency}, map, map.regs(true, false), 5000), 5000 + 31 + static_cast<std::uint64_t>(latency));
}

}  // namespace
}  // namespace relievo::test
