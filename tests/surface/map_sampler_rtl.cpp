// map_sampler: the circuit equals the kernel on every kind of map under all traffic; a sample a clock, 18 clocks and the memory's later.
// verilate: Vmap_sampler InFlight=128
// verilate: Vmap_sampler_8 InFlight=8
#include "Vmap_sampler.h"
#include "Vmap_sampler_8.h"
#include "hls/surface/map_sampler.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/map_memories.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/stream_unit.hpp"

namespace relievo::test {
namespace {

using vector = map_stimulus<hls::map_sampler_in>;

template <class Model>
std::uint64_t clocks_of(traffic const& t, test_map const& map, hls::map_regs const& regs, std::uint64_t count) {
  const auto shape = [&](vector& v, generator& g) {
    v.map = regs;
    coordinates_within(v.in.u, regs, g);
  };
  const auto expected = [&](vector const& v) { return hls::map_sampler(v.in, regs, map.texels()); };
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

TEST(map_sampler, rtl_equals_hls) { on_all_maps<Vmap_sampler>(); }
// Places run out all the time.
TEST(map_sampler, rtl_equals_hls_with_few_places) { on_all_maps<Vmap_sampler_8>(); }

TEST(map_sampler, a_sample_a_clock) {
  generator g("rate");
  const test_map map(13, 37, fill::random, g);
  for (const std::int64_t latency : {1, 60})
    EXPECT_EQ(clocks_of<Vmap_sampler>({0, 0, latency, latency}, map, map.regs(true, false), 5000),
              5000 + 18 + static_cast<std::uint64_t>(latency));
}

}  // namespace
}  // namespace relievo::test
