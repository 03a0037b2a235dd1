// normal_sampler: the circuit equals the kernel on every kind of map under all traffic; a normal a clock, 18 clocks and the memory's
// later.
// verilate: Vnormal_sampler InFlight=128
// verilate: Vnormal_sampler_8 InFlight=8
#include "Vnormal_sampler.h"
#include "Vnormal_sampler_8.h"
#include "hls/surface/normal_sampler.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/map_memories.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/stream_unit.hpp"

namespace relievo::test {
namespace {

using vector = map_stimulus<hls::normal_sampler_in>;

template <class Model>
std::uint64_t clocks_of(traffic const& t, test_map const& map, hls::map_regs const& regs, std::uint64_t count) {
  const auto shape = [&](vector& v, generator& g) {
    v.map = regs;
    coordinates_within(v.in.u, regs, g);
  };
  const auto expected = [&](vector const& v) { return hls::normal_sampler(v.in, regs, map.normals()); };
  const auto answers = normal_answers(map);
  return stream_test<Model, vector>(t, shape, expected, {RELIEVO_MEMORY_PORT(Model, normal, quad_request, answers)}, count);
}

template <class Model>
void on_all_maps() {
  const auto list = all_traffic();
  for_maps([&](test_map const& map, hls::map_regs const& regs) {
    for (traffic const& t : list) clocks_of<Model>(t, map, regs, rtl_vector_count() / (2 * map_case_count * list.size()) + 1);
  });
}

TEST(normal_sampler, rtl_equals_hls) { on_all_maps<Vnormal_sampler>(); }
// Places run out all the time.
TEST(normal_sampler, rtl_equals_hls_with_few_places) { on_all_maps<Vnormal_sampler_8>(); }

TEST(normal_sampler, a_normal_a_clock) {
  generator g("rate");
  const test_map map(13, 37, fill::random, g);
  for (const std::int64_t latency : {1, 60})
    EXPECT_EQ(clocks_of<Vnormal_sampler>({0, 0, latency, latency}, map, map.regs(true, false), 5000),
              5000 + 18 + static_cast<std::uint64_t>(latency));
}

}  // namespace
}  // namespace relievo::test
