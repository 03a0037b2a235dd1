// engine: the circuit puts out the kernel's triangles, as a multiset of raw records, and counts what it counts, on random scenes under all
// traffic; the clocks of one triangle are the sum of its units' latencies. Whole scenes among checkers on every link: tests/cosim.
// model: Vengine
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "Vengine.h"
#include "tests/support/engine_loop.hpp"
#include "tests/support/engine_scene.hpp"
#include "tests/support/engine_words.hpp"

namespace relievo::test {
namespace {

// As rtl/CMakeLists.txt builds it: 12 table words and 4 samples of a profile a clock.
using loop = engine_loop<Vengine, 12, 4>;

struct circuit_run {
  std::vector<hls::triangle_out> triangles;
  std::vector<std::uint64_t> counters;
  std::uint64_t clocks;
};

circuit_run run_circuit(loop& circuit, engine_scene const& s, tb::cosim_settings const& traffic) {
  const auto words = base_words(s.base);
  circuit_run run;
  run.clocks = circuit.run({s.regs, &words, {s.map.texels(), s.map.table(), {s.normals.data()}}}, traffic,
                           [&](hls::triangle_out const& t) { run.triangles.push_back(t); });
  run.counters = circuit.counters();
  return run;
}

void expect_same_run(circuit_run const& rtl, hls_run const& hls) {
  for (std::size_t i = 0; i < rtl.triangles.size(); ++i) ASSERT_EQ(rtl.triangles[i].last, i + 1 == rtl.triangles.size()) << "record " << i;
  expect_same_set(rtl.triangles, hls.triangles);
  const counter_list counts = list_of(hls.counts);
  ASSERT_EQ(counts.size(), rtl.counters.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    // What the queue counts is a matter of time.
    const bool timed = counts[i].first == "queue_high_water" || counts[i].first == "fifo_fallbacks";
    if (!timed) {
      ASSERT_EQ(rtl.counters[i], counts[i].second) << counts[i].first << ", rtl against hls";
    }
  }
}

tb::cosim_settings any_traffic(generator& g) {
  tb::cosim_settings t;
  t.idle = g.chance(2) ? 0 : 45;
  t.stall = g.chance(2) ? 0 : 45;
  t.latency_low = g.chance(2) ? 1 : static_cast<int>(g.between(1, 60));
  t.latency_high = g.chance(2) ? t.latency_low : t.latency_low + 40;
  t.bursty = g.chance(4);
  t.seed = 1 + g.below(1000000);
  return t;
}

// All in one circuit, which is reset once: a mesh follows the other with other registers.
TEST(engine, rtl_equals_hls_on_random_scenes) {
  loop circuit(static_cast<int>(seed() & 0x7fffffff) + 1);
  const auto kernel = std::make_unique<hls::engine<49>>();
  generator g("circuit");
  counter_list seen = list_of(hls::counters());
  for (std::uint64_t i = 0; i < std::max<std::uint64_t>(vector_count() / 4000, 40); ++i) {
    const engine_scene s = random_scene(g, static_cast<int>(g.between(0, 5)));
    const tb::cosim_settings traffic = any_traffic(g);
    const hls_run expected = run_hls(*kernel, s);
    expect_same_run(run_circuit(circuit, s, traffic), expected);
    if (HasFailure()) FAIL() << "scene " << i << ", seed " << seed() << "\n" << describe(s.regs);
    const counter_list counts = list_of(expected.counts);
    for (std::size_t k = 0; k < seen.size(); ++k) seen[k].second += counts[k].second;
  }
  for (auto const& counter : seen) {
    // A queue of 4,096 entries never falls back on these.
    if (counter.first != "fifo_fallbacks") {
      EXPECT_GT(counter.second, 0u) << "no scene made " << counter.first << " count";
    }
  }
}

// A plane of two triangles on a map of 8 x 8 texels that is seen from above; no test asks for a split.
engine_scene still_scene(std::size_t triangles) {
  generator g("still");
  engine_scene s(test_map(8, 8, fill::random, g));
  s.regs.map = s.map.regs(false, false);
  s.calm_camera();
  s.regs.pass.max_generation = hls::from_raw<formats::generation>(3);
  s.build_normals();
  s.add_plane(1, 1);
  s.base.resize(triangles);
  if (triangles != 0) s.base.back().last = true;
  return s;
}

TEST(engine, a_mesh_may_end_without_a_last_triangle) {
  loop circuit;
  const auto kernel = std::make_unique<hls::engine<49>>();
  const engine_scene whole = still_scene(2);
  const hls_run expected = run_hls(*kernel, whole);
  ASSERT_EQ(expected.triangles.size(), 2u);
  engine_scene open = whole;
  open.base.back().last = false;
  circuit.end_input();
  expect_same_run(run_circuit(circuit, open, {}), expected);
  // Nor need it have any.
  circuit.end_input();
  const circuit_run none = run_circuit(circuit, still_scene(0), {});
  ASSERT_EQ(none.triangles.size(), 1u);
  EXPECT_TRUE(none.triangles[0].empty && none.triangles[0].last);
  expect_same_run(run_circuit(circuit, whole, {}), expected);
}

// The place of a vertex and its normal clip, and each counts.
TEST(engine, a_vertex_saturates_twice) {
  loop circuit;
  const auto kernel = std::make_unique<hls::engine<49>>();
  engine_scene s = still_scene(1);
  s.regs.displace.bias = hls::from_raw<formats::height>(hls::fixed<formats::height>::max_raw);
  for (hls::vertex& v : s.base[0].v)
    for (int i = 0; i < 3; ++i) {
      v.n[i] = hls::from_raw<formats::unit>(32767);
      v.t[i] = hls::from_raw<formats::unit>(i == 0 ? -32768 : 32767);
    }
  const hls_run expected = run_hls(*kernel, s);
  EXPECT_EQ(expected.counts.saturations, 6u);
  expect_same_run(run_circuit(circuit, s, {}), expected);
}

// ---- clocks ------------------------------------------------------------------------------------------------------------------------

// Of what a triangle passes, by the headers of the units.
constexpr int fifo = 3;
constexpr int get_triangle = 1;
constexpr int three_edges = 2;  // the third enters the lane two clocks after the first
constexpr int front = 6 + fifo;
constexpr int beside_the_map_tests = fifo, summed_height_test = 63;  // and the memory
constexpr int new_vertex = 25 + fifo;
constexpr int beside_the_maps = fifo, displace_vertex = 31;  // and the memory
constexpr int registers = 4;                                 // around the two joins of a lane, and where it forks
constexpr int back = 37 + fifo;
constexpr int tessellate = fifo + 2;
constexpr int queue = 3;
// Start, the queue's first permission, the record that is held back, the queue's last word, the FIFO in front of the output.
constexpr int ends = 6 + fifo;

constexpr int round_of(int map_tests, int maps) {
  return get_triangle + three_edges + front + map_tests + new_vertex + maps + registers + back + tessellate;
}

// A base triangle goes round for its vertices, and once more for its edges where generations are left. Nothing splits.
TEST(engine, clocks_of_one_triangle) {
  loop circuit;
  engine_scene s = still_scene(1);
  s.regs.normal.threshold = hls::from_raw<formats::normal_threshold>(hls::fixed<formats::normal_threshold>::max_raw);
  s.regs.summed_height.sum_threshold = hls::from_raw<formats::sum_threshold>(hls::fixed<formats::sum_threshold>::max_raw);
  for (const int m : {1, 2, 60}) {
    const auto clocks = [&](int max_generation, bool nt, bool sht) {
      s.regs.pass = {};
      s.regs.pass.max_generation = hls::from_raw<formats::generation>(max_generation);
      s.regs.pass.use_nt = nt;
      s.regs.pass.use_sht = sht;
      tb::cosim_settings traffic;
      traffic.latency_low = traffic.latency_high = m;
      const circuit_run run = run_circuit(circuit, s, traffic);
      EXPECT_EQ(run.triangles.size(), 1u);
      return static_cast<int>(run.clocks);
    };
    const int vertices = ends + round_of(beside_the_map_tests, displace_vertex + m);
    EXPECT_EQ(clocks(0, true, true), vertices) << "memory latency " << m;
    EXPECT_EQ(clocks(3, false, false), vertices + queue + round_of(beside_the_map_tests, beside_the_maps)) << "memory latency " << m;
    EXPECT_EQ(clocks(3, true, false), vertices + queue + round_of(beside_the_map_tests, displace_vertex + m)) << "memory latency " << m;
    EXPECT_EQ(clocks(3, false, true), vertices + queue + round_of(summed_height_test + m, beside_the_maps)) << "memory latency " << m;
    EXPECT_EQ(clocks(3, true, true), vertices + queue + round_of(summed_height_test + m, displace_vertex + m)) << "memory latency " << m;
  }
}

}  // namespace
}  // namespace relievo::test
