// Small meshes with every test through the smallest engine, with stalls and a watchdog that does not wait long: what a broken circuit is
// held against (tests/mutants/rtl). With few generations the queue lets several triangles go at once, with all of them one at a time.
#include <gtest/gtest.h>

#include "tb/cosim/rtl_model.hpp"
#include "tb/host/scene.hpp"
#include "tb/model/compare.hpp"
#include "tests/cosim/engines.hpp"

namespace relievo::test {
namespace {

// Without an edge longer than so many pixels; the more generations, the fewer entries are free for others.
tb::scene small_scene(char const* map, double pixels, int max_generation, bool cull = false) {
  tb::scene_options o;
  o.mesh = "octahedron";
  o.displacement = map;
  o.wrap = std::array<bool, 2>{true, false};
  o.tests = tb::parse_tests("nt,sht,pt,ht,vt,ct", "tests");
  o.normal_threshold = 0.1;
  o.view_threshold = pixels;
  o.max_generation = max_generation;
  o.cull = cull;
  return tb::make_scene(o);
}

tb::scene few() { return small_scene("sine:32,16", 100, 3); }

tb::cosim_settings rough() {
  tb::cosim_settings s;
  s.variant = "small";
  s.idle = 20;
  s.stall = 50;
  s.latency_high = 20;
  s.watchdog = 2000;
  return s;
}

void equals_hls(tb::scene const& sc, tb::cosim_settings const& settings = rough()) {
  const tb::run_result hls = tb::run_model("hls", sc);
  const cosim_run rtl = run_circuit(sc, settings);
  const tb::comparison c = tb::compare_runs("hls", hls, "rtl", rtl.run, false);
  EXPECT_EQ(c.words_different, 0u) << c.first_difference;
  for (std::string const& line : c.counters_different) ADD_FAILURE() << line;
  EXPECT_TRUE(rtl.run.triangles.back().last);
}

TEST(small_engine, runs_a_mesh) { equals_hls(few()); }

TEST(small_engine, runs_a_mesh_into_a_slow_sink) {
  tb::cosim_settings slow = rough();
  slow.stall = 95;
  equals_hls(few(), slow);
}

TEST(small_engine, runs_a_mesh_that_fills_its_queue) { equals_hls(small_scene("sine:32,16", 40, 3)); }

TEST(small_engine, runs_a_mesh_with_no_entry_to_spare) { equals_hls(small_scene("sine:6,4", 200, 15)); }

TEST(small_engine, runs_a_mesh_after_a_reset_in_another) {
  const tb::scene sc = few();
  for (const std::uint64_t clocks : {400, 777}) {
    tb::set_cosim_abort(clocks);
    run_circuit(sc, rough());
  }
  tb::set_cosim_abort(0);
  equals_hls(sc);
}

// A triangle's three edges at once, and three triangles that end at once.
TEST(three_lanes, runs_a_mesh) {
  tb::cosim_settings wide = rough();
  wide.variant = "wide";
  equals_hls(few(), wide);
}

// What faces away passes by an output that is full.
TEST(three_lanes, culls_into_a_slow_sink) {
  tb::cosim_settings slow = rough();
  slow.variant = "wide";
  slow.stall = 95;
  equals_hls(small_scene("sine:32,16", 100, 2, true), slow);
}

}  // namespace
}  // namespace relievo::test
