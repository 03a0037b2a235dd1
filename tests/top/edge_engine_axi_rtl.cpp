// campaign: a second whole engine takes a minute to compile
// verilate: Vedge_engine_axi SAT_READS_PER_CLOCK=4 PROFILE_SAMPLES_PER_CLOCK=4 QUEUE_DEPTH=128 MAX_GENERATION=6 OUTSTANDING=32
// edge_engine_axi: the circuit with its maps behind AXI4 buses: the triangles and counters of hls::engine whatever the buses do, and an
// error of a memory told to the host.
#include <gtest/gtest.h>

#include "Vedge_engine_axi.h"
#include "tests/support/edge_engine_session.hpp"
#include "tests/support/map_buses.hpp"

namespace relievo::test {
namespace {

using session = edge_engine_session<Vedge_engine_axi, map_buses<Vedge_engine_axi>>;
using code = tb::edge_engine_code;

TEST(edge_engine_axi, rtl_equals_hls_on_scenes_back_to_back) {
  generator g("scenes");
  const traffic patterns[] = {{0, 0, 1, 1}, {0, 7, 1, 40}, {7, 0, 1, 40}, {5, 5, 60, 60}};
  std::uint64_t tests = 0, samples = 0;
  for (traffic const& t : patterns) {
    session it(t);
    for (int i = 0; i < 12; ++i) {
      const engine_scene s = random_scene(g, static_cast<int>(g.between(0, 4)));
      it.run(s, i % 2 != 0);
      if (HasFatalFailure()) FAIL() << "scene " << i << ", seed " << seed() << "\n" << describe(s.regs);
      tests += it.bench.driver.counters().edge_tests;
      samples += it.bench.driver.counters().profile_samples;
    }
  }
  EXPECT_GT(tests, 1000u);
  EXPECT_GT(samples, 1000u);
}

// Each bus in its turn; the words were right all the same, so the mesh is.
TEST(edge_engine_axi, tells_of_a_memory_that_fails) {
  generator g("failing");
  for (const int beats : {1, 7, 200}) {
    session it({0, 3, 1, 20});
    const engine_scene s = good_scene(g);
    it.build_maps(s);
    it.bench.memories.bad_beats = beats;
    it.begin(s, static_cast<std::uint32_t>(s.base.size()));
    it.send(s);
    it.expect_mesh(s, code::memory_error);
    it.expect_line(code::memory_error, "a map memory answered");
    if (HasFatalFailure()) FAIL() << "seed " << seed();
    it.bench.memories.bad_beats = 0;
    it.bench.driver.clear_error();
    it.run(good_scene(g), true);
    if (HasFatalFailure()) FAIL() << "the good scene afterwards, seed " << seed();
  }
}

// Whatever was under way: a mesh, a map, an access of the host, reads of the memories.
TEST(edge_engine_axi, survives_a_reset_in_the_middle) {
  generator g("reset");
  for (traffic const& t : {traffic{0, 0, 1, 1}, traffic{4, 6, 1, 40}}) {
    session it(t);
    for (const int clocks : {1, 2, 3, 40, 41, 150, 333, 700, 1500}) {
      const engine_scene s = good_scene(g);
      it.build_maps(s);
      it.begin(s, 0);
      it.send(s);
      it.bench.clock(clocks);
      it.bench.texels.assign(9, {7, false});
      it.bench.clock(clocks % 13);
      it.bench.reset();
      it.run(good_scene(g), true);
      if (HasFatalFailure()) FAIL() << "reset after " << clocks << " clocks, seed " << seed();
    }
  }
}

}  // namespace
}  // namespace relievo::test
