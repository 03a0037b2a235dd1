// A reset in the middle of a mesh leaves nothing behind; meshes follow each other with other registers without a reset; the watchdog names
// the link that stopped.
#include <gtest/gtest.h>

#include "tb/cosim/rtl_model.hpp"
#include "tb/host/scene.hpp"
#include "tb/model/compare.hpp"
#include "tests/cosim/engines.hpp"

namespace relievo::test {
namespace {

tb::scene scene_of(char const* mesh, char const* map, double threshold) {
  tb::scene_options o;
  o.mesh = mesh;
  o.displacement = map;
  o.normal_threshold = threshold;
  o.max_generation = 6;
  return tb::make_scene(o);
}

void expect_equal(tb::scene const& sc, tb::run_result const& rtl) {
  const tb::comparison c = tb::compare_runs("hls", tb::run_model("hls", sc), "rtl", rtl, false);
  EXPECT_TRUE(c.equal()) << c.first_difference;
}

TEST(resets, in_the_middle_of_a_mesh) {
  const tb::scene sc = scene_of("plane:3", "half-donut", 0.1);
  tb::cosim_settings s;
  s.stall = 30;
  s.latency_high = 30;
  for (const std::uint64_t clocks : {1, 2, 3, 150, 151, 400, 1234, 2000}) {
    tb::set_cosim_abort(clocks);
    run_circuit(sc, s);
    tb::set_cosim_abort(0);
    expect_equal(sc, run_circuit(sc, s).run);
  }
}

TEST(resets, none_between_meshes_with_other_registers) {
  tb::set_cosim_reset_between(false);
  for (int round = 0; round < 3; ++round) {
    const tb::scene one = scene_of("plane:3", "half-donut", 0.1);
    expect_equal(one, run_circuit(one, {}).run);
    const tb::scene other = scene_of("sphere:4", "sine:50,30", 0.3);
    expect_equal(other, run_circuit(other, {}).run);
  }
}

// Memories that refuse ninety-nine requests of a hundred: the first request is what waits.
TEST(watchdog, names_a_link_whose_words_are_not_taken) {
  const tb::scene sc = scene_of("plane:3", "half-donut", 0.1);
  tb::cosim_settings s;
  s.watchdog = 60;
  s.stall = 99;
  try {
    run_circuit(sc, s);
    ADD_FAILURE() << "nobody saw that nothing moves";
  } catch (tb::cosim_error const& e) {
    EXPECT_NE(std::string(e.what()).find("requests are not taken; all links:"), std::string::npos) << e.what();
  }
}

TEST(watchdog, names_the_memory_that_does_not_answer) {
  const tb::scene sc = scene_of("plane:3", "half-donut", 0.1);
  tb::cosim_settings s;
  s.watchdog = 500;
  s.latency_low = s.latency_high = 2000;
  try {
    run_circuit(sc, s);
    ADD_FAILURE() << "a memory of 2,000 clocks was waited for";
  } catch (tb::cosim_error const& e) {
    // The first read of a base vertex is that of its displacement.
    EXPECT_NE(std::string(e.what()).find("clocks, and displacement answers do not come, "), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace relievo::test
