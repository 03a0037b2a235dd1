// verilate: Vedge_counters Lanes=3
// edge_counters: every event is counted exactly two clocks after it, one in every clock and lane; clearing forgets what is on its way too.
#include <gtest/gtest.h>

#include <array>

#include "Vedge_counters.h"
#include "hls/edge/counters.hpp"
#include "hls/top/top.hpp"
#include "tb/cosim/ports.hpp"
#include "tb/cosim/ports_of_lanes.hpp"
#include "tests/support/clocked_model.hpp"
#include "tests/support/random.hpp"

namespace relievo::test {
namespace {

constexpr int lanes = 3;

// The places of rtl/edge/engine_pkg.sv.
enum place {
  triangles_in,
  triangles_out,
  culled,
  edge_tests,
  settled_skips,
  tests_vt,  // and ct, nt, sht, pt, ht
  splits = 11,
  vertices = 15,
  high_water,
  fallbacks,
  saturations,
  screen_saturations,
  zero_vectors,
  table_reads,
  profile_samples
};
using counts = std::array<std::uint64_t, hls::top::counter_words>;

// lane_counts_t of rtl/edge/lane_pkg.sv, from bit 0: edge_test, vt, ct, nt, sht, pt, ht, vertex, saturations, screen_saturation,
// zero_vectors, table_read, profile_samples.
constexpr int lane_width = 19;
void add_lane(std::uint64_t word, counts& c) {
  const auto take = [&](int width) {
    const std::uint64_t x = word & ((std::uint64_t(1) << width) - 1);
    word >>= width;
    return x;
  };
  c[edge_tests] += take(1);
  for (int test = 0; test < 6; ++test) c[static_cast<std::size_t>(tests_vt + test)] += take(1);
  c[vertices] += take(1);
  c[saturations] += take(2);
  c[screen_saturations] += take(1);
  c[zero_vectors] += take(2);
  c[table_reads] += 12 * take(1);
  c[profile_samples] += take(5);
}

std::uint64_t ones(std::uint64_t word) { return word == 0 ? 0 : (word & 1) + ones(word >> 1); }

// Events of one clock, and what they add.
counts draw_events(Vedge_counters& m, generator& g) {
  counts c{};
  m.in_i = g.chance(2);
  m.tested_i = g.chance(2);
  m.settled_i = static_cast<CData>(g.below(8));
  m.split_i = static_cast<CData>(g.below(8));
  m.born_i = g.chance(3);
  m.out_i = g.chance(2);
  m.culled_i = g.chance(4);
  m.lane_valid_i = static_cast<CData>(g.below(1 << lanes));
  hls::bits<64> words = {};
  // An edge has 17 samples at most.
  for (int i = 0; i < lanes; ++i) words.limb[0] |= (g.below(1 << (lane_width - 5)) | g.below(18) << (lane_width - 5)) << (i * lane_width);
  tb::put_bits(m.lane_i, 0, words, lanes * lane_width);
  c[triangles_in] = m.in_i;
  c[triangles_out] = m.out_i;
  c[culled] = m.culled_i;
  for (int i = 0; i < lanes; ++i)
    if (((m.lane_valid_i >> i) & 1) != 0) add_lane(words.limb[0] >> (i * lane_width), c);
  if (m.tested_i) {
    c[settled_skips] += ones(m.settled_i);
    c[splits + ones(m.split_i)] += 1;
  }
  if (m.born_i) {
    c[settled_skips] += 3;
    c[splits] += 1;
  }
  return c;
}

void expect_counts(Vedge_counters& m, counts const& expected) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::uint64_t count = tb::get_bits<64>(m.counters_o, static_cast<int>(64 * i), 64).limb[0];
    // The queue counts these two itself.
    ASSERT_EQ(count, i == high_water ? m.high_water_i : i == fallbacks ? m.fallbacks_i : expected[i]) << "counter " << i;
  }
}

void add(counts& sum, counts const& more) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += more[i];
}

TEST(edge_counters, counts_two_clocks_later_what_happens_in_every_clock) {
  clocked_model<Vedge_counters> m;
  generator g("counters");
  m->clear_i = 0;
  draw_events(*m, g);
  m.reset();
  for (int mesh = 0; mesh < 20; ++mesh) {
    m->clear_i = 1;
    draw_events(*m, g);
    m.clock();
    m->clear_i = 0;
    counts sum{}, before{};
    for (int i = 0; i < 500; ++i) {
      const counts now = draw_events(*m, g);
      m->high_water_i = static_cast<SData>(g());
      m->fallbacks_i = g();
      m.clock();
      // What was before this clock's events has its second clock behind it.
      add(sum, before);
      before = now;
      expect_counts(*m, sum);
      if (HasFatalFailure()) FAIL() << "clock " << i << " of mesh " << mesh << ", seed " << seed();
    }
  }
}

}  // namespace
}  // namespace relievo::test
