// Every scene of the list through the circuit: the same triangles as hls, as multisets of raw records, and the same counters, whatever the
// traffic on its links; the small engine has the smallest queue that the proof allows.
#include <gtest/gtest.h>

#include <algorithm>

#include "tb/model/compare.hpp"
#include "tests/cosim/engines.hpp"
#include "tests/system/scenes.hpp"

namespace relievo::test {
namespace {

// The smallest queue lets few triangles into the pipeline at once, so its scenes take some hundred clocks a triangle: the regression runs
// those with fewer edges than this, a campaign all.
constexpr std::uint64_t all = ~std::uint64_t(0);
constexpr std::uint64_t edges_in_other_engines = RELIEVO_CAMPAIGN ? all : 6000;
// Rough traffic doubles the clocks and the wait.
constexpr std::uint64_t edges_in_rough_traffic = RELIEVO_CAMPAIGN ? all : 50000;

void equals_hls(tb::scene const& sc, tb::cosim_settings const& settings, std::uint64_t most_edges = all) {
  const tb::run_result hls = tb::run_model("hls", sc);
  if (hls.counts.edge_tests > most_edges) GTEST_SKIP() << hls.counts.edge_tests << " edge tests are left to scripts/regress.sh";
  const cosim_run rtl = run_circuit(sc, settings);
  ASSERT_FALSE(hls.triangles.empty());
  const tb::comparison c = tb::compare_runs("hls", hls, "rtl", rtl.run, false);
  EXPECT_EQ(c.words_different, 0u) << c.first_difference;
  for (std::string const& line : c.counters_different) ADD_FAILURE() << line;
  EXPECT_TRUE(rtl.run.triangles.back().last);
  for (std::size_t i = 0; i + 1 < rtl.run.triangles.size(); ++i) ASSERT_FALSE(rtl.run.triangles[i].last) << i;
}

int scene_count() { return static_cast<int>(all_scenes().size()); }
std::string scene_name(int at) {
  std::string name = all_scenes()[static_cast<std::size_t>(at)].name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

// Every scene: once with everything at hand, once with everything in the way, with other words in the registers before reset.
class scene_in_traffic : public testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(scene_in_traffic, rtl_equals_hls) {
  const auto [at, rough] = GetParam();
  tb::cosim_settings s;
  if (rough) {
    s.idle = s.stall = 40;
    s.latency_high = 90;
    s.seed = 2;
    s.reset_seed = 77;
  }
  equals_hls(all_scenes()[static_cast<std::size_t>(at)].make(), s, rough ? edges_in_rough_traffic : all);
}

std::string name_in_traffic(testing::TestParamInfo<std::tuple<int, bool>> const& info) {
  return scene_name(std::get<0>(info.param)) + (std::get<1>(info.param) ? "_rough" : "_smooth");
}
INSTANTIATE_TEST_SUITE_P(scenes, scene_in_traffic, testing::Combine(testing::Range(0, scene_count()), testing::Bool()), name_in_traffic);

// {no idle, idle} x {no stall, stall} x {latency 1, random, bursty}, two reset seeds, on one scene with every test.
class every_traffic : public testing::TestWithParam<std::tuple<int, int, int, int>> {};

TEST_P(every_traffic, rtl_equals_hls) {
  const auto [idle, stall, memory, reset_seed] = GetParam();
  tb::scene_options o;
  o.mesh = "sphere:4";
  o.displacement = "sine:64,32";
  o.wrap = std::array<bool, 2>{true, false};
  o.tests = tb::parse_tests("nt,sht,pt,ht,vt,ct", "tests");
  o.max_generation = 6;
  tb::cosim_settings s;
  s.idle = idle;
  s.stall = stall;
  s.latency_high = memory == 1 ? 60 : 1;
  s.bursty = memory == 2;
  s.reset_seed = reset_seed;
  s.seed = static_cast<std::uint64_t>(7 * idle + stall + memory + reset_seed);
  equals_hls(tb::make_scene(o), s);
}

std::string traffic_name(testing::TestParamInfo<std::tuple<int, int, int, int>> const& info) {
  const auto [idle, stall, memory, seed] = info.param;
  static char const* const memories[3] = {"_latency_1", "_latency_random", "_bursty"};
  return std::string(idle != 0 ? "idle" : "busy") + (stall != 0 ? "_stall" : "_open") + memories[memory] + "_reset_" + std::to_string(seed);
}
INSTANTIATE_TEST_SUITE_P(traffic, every_traffic,
                         testing::Combine(testing::Values(0, 50), testing::Values(0, 50), testing::Values(0, 1, 2),
                                          testing::Values(1, 4711)),
                         traffic_name);

// The smallest queue, and three lanes; in a campaign the engine as somebody else's RTL.
class other_engines : public testing::TestWithParam<std::tuple<char const*, int>> {};

TEST_P(other_engines, rtl_equals_hls) {
  const auto [variant, at] = GetParam();
  tb::cosim_settings s;
  s.variant = variant;
  s.latency_high = 20;
  s.stall = 20;
  equals_hls(all_scenes()[static_cast<std::size_t>(at)].make(), s, edges_in_other_engines);
}

std::string engine_name(testing::TestParamInfo<std::tuple<char const*, int>> const& info) {
  return std::string(std::get<0>(info.param)) + "_" + scene_name(std::get<1>(info.param));
}
std::vector<char const*> variants() {
#if RELIEVO_CAMPAIGN
  return {"small", "wide", "foreign"};
#else
  return {"small", "wide"};
#endif
}
INSTANTIATE_TEST_SUITE_P(scenes, other_engines, testing::Combine(testing::ValuesIn(variants()), testing::Range(0, scene_count())),
                         engine_name);

// The paper's order: the oldest first where the queue has room for it.
TEST(fifo_mode, puts_out_the_same_triangles) {
  tb::scene_options o;
  o.mesh = "plane:3";
  o.displacement = "half-donut";
  o.fifo = true;
  equals_hls(tb::make_scene(o), {});
}

TEST(fifo_mode, falls_back_in_the_smallest_queue) {
  tb::scene_options o;
  o.mesh = "plane:3";
  o.displacement = "half-donut";
  o.fifo = true;
  o.max_generation = 4;
  tb::cosim_settings s;
  s.variant = "small";
  const tb::scene sc = tb::make_scene(o);
  equals_hls(sc, s);
  EXPECT_GT(run_circuit(sc, s).run.counts.fifo_fallbacks, 0u);
}

}  // namespace
}  // namespace relievo::test
