// edge_engine: every error of a map; the builders still put out a whole map of some kind, or nothing, and a good mesh runs after it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/edge_engine_stories.hpp"

namespace relievo::test {
namespace {

TEST(edge_engine, survives_a_map_of_a_wrong_size) {
  for (const std::int64_t size : {0, 8193, 16383})
    for (const bool of_width : {true, false})
      tell([&](session& it, engine_scene s) {
        (of_width ? s.regs.map.width : s.regs.map.height) = hls::from_raw<formats::map_size>(size);
        it.bench.driver.set(s.regs);
        it.bench.table.clear();
        it.bench.normals.clear();
        for (int i = 0; i < 20; ++i) it.bench.texels.push_back({5, i == 19});
        it.wait_for_map();
        it.bench.clock(200);
        ASSERT_TRUE(it.bench.table.empty() && it.bench.normals.empty());
        const code wrong = size == 0 ? code::map_size_zero : code::map_size_too_large;
        it.expect_line(wrong, std::to_string(size));
      });
}

TEST(edge_engine, survives_a_map_that_ends_early) {
  for (const bool stopped : {false, true})
    tell([&](session& it, engine_scene s) {
      generator g("short");
      s = engine_scene(test_map(7, 5, fill::random, g));
      s.regs.map = s.map.regs(false, true);
      it.bench.driver.set(s.regs);
      it.bench.table.clear();
      it.bench.normals.clear();
      for (int i = 0; i < 17; ++i) it.bench.texels.push_back({s.map.words()[static_cast<std::size_t>(i)], i == 16 && !stopped});
      if (stopped) {
        it.bench.clock(300);
        ASSERT_TRUE(it.bench.driver.state().map_busy);
        it.bench.driver.stop();
      }
      it.wait_for_map();
      ASSERT_EQ(it.bench.table.size(), 35u);
      ASSERT_EQ(it.bench.normals.size(), 35u);
      // Zeros for what did not come.
      std::vector<std::uint16_t> filled = s.map.words();
      std::fill(filled.begin() + 17, filled.end(), std::uint16_t(0));
      const auto sums = golden::summed_area_table(filled.data(), 7, 5);
      for (int i = 0; i < 35; ++i) ASSERT_EQ(it.bench.table[std::make_pair(i % 7, i / 7)], sums[static_cast<std::size_t>(i)]) << i;
      it.expect_line(stopped ? code::stopped : code::map_early_last,
                     stopped ? "stop was written" : "before the last texel of a map of 7 x 5");
      it.bench.driver.clear_error();
    });
}

// What follows is swallowed, up to its tlast or until the host has seen it.
TEST(edge_engine, survives_a_map_that_does_not_end) {
  for (const int more : {0, 1, 9})
    tell([&](session& it, engine_scene const& s) {
      it.bench.driver.set(s.regs);
      it.bench.driver.set(s.normal_regs);
      it.bench.table.clear();
      it.bench.normals.clear();
      for (std::uint16_t const word : s.map.words()) it.bench.texels.push_back({word, false});
      for (int i = 0; i < more; ++i) it.bench.texels.push_back({7, i + 1 == more});
      it.wait_for_map();
      it.bench.clock(200);
      it.expect_maps(s);
      ASSERT_EQ(it.bench.driver.state().swallowing, more == 0);
      it.expect_line(code::map_missing_last, "without tlast");
      it.bench.driver.clear_error();
    });
}

// After a good scene all texels of a map without tlast, whose last row is still to come out when this returns.
engine_scene send_endless_map(session& it, generator& g) {
  it.run(good_scene(g), true);
  engine_scene s(test_map(100, 2, fill::random, g));
  s.regs.map = s.map.regs(false, true);
  s.build_normals();
  it.bench.driver.set(s.regs);
  it.bench.driver.set(s.normal_regs);
  it.bench.table.clear();
  it.bench.normals.clear();
  for (std::uint16_t const word : s.map.words()) it.bench.texels.push_back({word, false});
  while (!it.bench.texels.empty()) it.bench.clock();
  return s;
}

// The host may have seen it while the last row is still coming out; then nothing is swallowed.
TEST(edge_engine, forgets_the_rest_of_a_map_that_the_host_has_seen_before_it_was_out) {
  session it;
  generator g("flush");
  const engine_scene s = send_endless_map(it, g);
  it.bench.clock(5);
  it.expect_line(code::map_missing_last, "without tlast");
  it.bench.driver.clear_error();
  const tb::edge_engine_state state = it.bench.driver.state();
  ASSERT_TRUE(state.map_busy) << "too late";
  ASSERT_FALSE(state.error);
  it.wait_for_map();
  it.expect_maps(s);
  ASSERT_FALSE(it.bench.driver.state().swallowing);
  it.run(good_scene(g), true);
}

// A mesh that begins says nothing of texels: while the map is still coming out, and when it is out and the rest is waited for.
TEST(edge_engine, makes_no_map_of_the_rest_of_another_when_a_mesh_begins) {
  for (const bool out : {false, true}) {
    session it;
    generator g("rest");
    const engine_scene s = send_endless_map(it, g);
    it.bench.clock(out ? 500 : 5);
    ASSERT_EQ(it.bench.driver.state().map_busy, !out);
    const engine_scene mesh = good_scene(g);
    it.begin(mesh, 0);
    ASSERT_FALSE(it.bench.driver.state().error) << "the start clears it";
    for (int i = 0; i < 9; ++i) it.bench.texels.push_back({7, i == 8});
    it.wait_for_map();
    it.bench.clock(200);
    it.expect_maps(s);
    // The host learns of it all the same.
    it.send(mesh);
    it.expect_mesh(mesh, code::map_missing_last);
    ASSERT_FALSE(it.bench.driver.state().swallowing);
    it.bench.driver.clear_error();
    it.run(good_scene(g), true);
    if (HasFatalFailure()) FAIL() << out << ", seed " << seed();
  }
}

}  // namespace
}  // namespace relievo::test
