// displace_vertex: the circuit equals the kernel on every kind of map under all traffic; a vertex a clock, 31 clocks and the memory's
// later.
// verilate: Vdisplace_vertex InFlight=128
// verilate: Vdisplace_vertex_8 InFlight=8
#include "Vdisplace_vertex.h"
#include "Vdisplace_vertex_8.h"
#include "hls/edge/displace_vertex.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/map_memories.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/stream_unit.hpp"

namespace relievo::test {
namespace {

using vector = map_stimulus<hls::displace_vertex_in, hls::displace_regs>;

template <class Model>
std::uint64_t clocks_of(traffic const& t, test_map const& map, hls::map_regs const& regs, std::uint64_t count) {
  const auto shape = [&](vector& v, generator& g) {
    v.map = regs;
    coordinates_within(v.in.u, regs, g);
    if (g.chance(2)) unit_vector(v.in.n, g);
  };
  const auto expected = [&](vector const& v) { return hls::displace_vertex(v.in, regs, v.regs, map.texels()); };
  const auto answers = texel_answers(map);
  return stream_test<Model, vector>(t, shape, expected, {RELIEVO_MEMORY_PORT(Model, quad, quad_request, answers)}, count);
}

template <class Model>
void on_all_maps() {
  const auto list = all_traffic();
  for_maps([&](test_map const& map, hls::map_regs const& regs) {
    for (traffic const& t : list) clocks_of<Model>(t, map, regs, rtl_vector_count() / (2 * map_case_count * list.size()) + 1);
  });
}

TEST(displace_vertex, rtl_equals_hls) { on_all_maps<Vdisplace_vertex>(); }
// Places run out all the time.
TEST(displace_vertex, rtl_equals_hls_with_few_places) { on_all_maps<Vdisplace_vertex_8>(); }

TEST(displace_vertex, a_vertex_a_clock) {
  generator g("rate");
  const test_map map(13, 37, fill::random, g);
  for (const std::int64_t latency : {1, 60})
    EXPECT_EQ(clocks_of<Vdisplace_vertex>({0, 0, latency, latency}, map, map.regs(true, false), 5000),
              5000 + 31 + static_cast<std::uint64_t>(latency));
}

}  // namespace
}  // namespace relievo::test
