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
  work_done done;
  run_back_to_back<session>({{0, 0, 1, 1}, {0, 7, 1, 40}, {7, 0, 1, 40}, {5, 5, 60, 60}}, done);
  EXPECT_GT(done.edge_tests, 1000u);
  EXPECT_GT(done.profile_samples, 1000u);
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

TEST(edge_engine_axi, survives_a_reset_in_the_middle) { reset_in_the_middle<session>({{0, 0, 1, 1}, {4, 6, 1, 40}}); }

}  // namespace
}  // namespace relievo::test
