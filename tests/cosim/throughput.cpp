// How many clocks a mesh may take, on the Jacksboro terrain at about 20,000 triangles: an edge a clock and lane where the memories deliver,
// the clocks of its reads where they don't, fill, queue and drain included. The counts are exact, so each is asserted as it is, beside the
// most that it may be: who changes a latency says here what it costs.
#include <gtest/gtest.h>

#include "tb/cosim/limited_by.hpp"
#include "tests/cosim/engines.hpp"
#include "tests/support/jacksboro.hpp"

namespace relievo::test {
namespace {

tb::scene_options terrain(bool profile) {
  tb::scene_options o = jacksboro();
  o.tests.pt = profile;
  o.tests.sht = !profile;  // else the reads of the table may be what takes the clocks
  if (profile) o.normal_threshold = 1.2;
  o.profile_threshold = 23;
  return o;
}

// One run: the terrain at its size, exactly these clocks, and what its report says that limited them.
cosim_run run_terrain(tb::scene const& sc, char const* variant, int latency, std::uint64_t clocks, char const* limit) {
  tb::cosim_settings s;
  s.variant = variant;
  s.latency_low = s.latency_high = latency;
  cosim_run r = run_circuit(sc, s);
  EXPECT_GT(r.run.counts.triangles_out, 19000u);
  EXPECT_LT(r.run.counts.triangles_out, 21000u);
  EXPECT_EQ(r.circuit.clocks, clocks);
  EXPECT_EQ(tb::limited_by(r.circuit), limit);
  return r;
}

double ratio(std::uint64_t clocks, double base, char const* of) {
  const double r = static_cast<double>(clocks) / base;
  std::printf("%llu clocks, %.4f %s\n", static_cast<unsigned long long>(clocks), r, of);
  return r;
}

char const table_words[] = "summed-area table answers: one in nearly every clock";
char const an_edge[] = "no memory: the pipeline takes an edge in nearly every clock";
char const a_triangle[] = "no memory: the pipeline takes a triangle in nearly every clock";
char const samples[] = "profile samples answers: one in nearly every clock";

void paper_tests(char const* variant, int clocks_per_edge, std::uint64_t clocks, char const* limit, int latency = 1) {
  const cosim_run r = run_terrain(tb::make_scene(terrain(false)), variant, latency, clocks, limit);
  EXPECT_LE(ratio(r.circuit.clocks, static_cast<double>(r.run.counts.edge_tests), "an edge test"), 1.10 * clocks_per_edge);
}

// The clocks that the samples of profiles need: n + 1 of an edge that gets as far, so many a clock; and one of every other edge that is
// tested, as the pipeline takes no more.
double clocks_of_samples(tb::scene const& sc, int samples_per_clock) {
  double clocks = 0;
  tb::run_hooks hooks;
  hooks.traced = [&](golden::edge_trace const& e) {
    const int n = e.pt.evaluated && e.intervals != 0 ? e.intervals + 1 : 0;
    clocks += std::max(1, (n + samples_per_clock - 1) / samples_per_clock);
  };
  tb::make_model("golden", sc)->run(hooks);
  return clocks;
}

void profiles(char const* variant, int samples_per_clock, std::uint64_t clocks) {
  const tb::scene sc = tb::make_scene(terrain(true));
  const cosim_run r = run_terrain(sc, variant, 1, clocks, samples);
  EXPECT_LE(ratio(r.circuit.clocks, clocks_of_samples(sc, samples_per_clock), "a clock that the samples need"), 1.10);
}

TEST(throughput, an_edge_a_clock_with_12_reads) { paper_tests("default", 1, 63785, an_edge); }

TEST(throughput, a_memory_latency_of_60_clocks_costs_a_tenth_at_most) { paper_tests("default", 1, 64432, an_edge, 60); }

TEST(throughput, profiles_with_4_samples_a_clock) { profiles("default", 4, 211704); }

TEST(throughput, a_triangle_a_clock_with_three_lanes_and_36_reads) {
  const cosim_run r = run_terrain(tb::make_scene(terrain(false)), "wide", 1, 37118, a_triangle);
  std::uint64_t tested = 0;
  for (const std::uint64_t n : r.run.counts.splits) tested += n;
  EXPECT_LE(ratio(r.circuit.clocks, static_cast<double>(tested), "a triangle tested"), 1.15);
}

#if RELIEVO_CAMPAIGN
TEST(throughput, with_1_read) { paper_tests("narrow", 12, 670265, table_words); }
TEST(throughput, with_3_reads) { paper_tests("three", 4, 224375, table_words); }
TEST(throughput, with_4_reads) { paper_tests("four", 3, 168236, table_words); }
TEST(throughput, profiles_with_1_sample_a_clock) { profiles("narrow", 1, 627323); }
TEST(throughput, profiles_with_16_samples_a_clock) { profiles("four", 16, 91460); }
#endif

}  // namespace
}  // namespace relievo::test
