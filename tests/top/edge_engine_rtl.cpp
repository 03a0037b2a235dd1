// model: Vedge_engine
// edge_engine: the circuit through its buses, maps built by its builders, meshes back to back with other registers: the triangles and
// counters of hls::engine. Its errors: edge_engine_rtl_errors.cpp.
#include <gtest/gtest.h>

#include "tests/support/edge_engine_stories.hpp"

namespace relievo::test {
namespace {

TEST(edge_engine, says_what_it_was_built_with) {
  session it;
  const tb::edge_engine_build b = it.bench.driver.build();
  EXPECT_EQ(b.lanes, built_with.lanes);
  EXPECT_EQ(b.sat_reads_per_clock, built_with.sat_reads_per_clock);
  EXPECT_EQ(b.profile_samples_per_clock, built_with.profile_samples_per_clock);
  EXPECT_EQ(b.queue_depth, built_with.queue_depth);
  EXPECT_EQ(b.max_generation, built_with.max_generation);
}

// What can be written and read back is the records' bits, whole words where more has to be refused, and expected_triangles; all else
// refuses to be written.
TEST(edge_engine, registers_hold_the_records_bits) {
  session it({5, 5, 1, 1});
  generator g("registers");
  it.bench.may_refuse = true;
  const auto bits = [](std::uint32_t word) {
    int n = 0;
    for (; word != 0; word &= word - 1) ++n;
    return n;
  };
  int held = 0, refused = 0;
  for (std::uint32_t address = 8; address < 0x400; address += 4) {
    it.bench.write32(address, 0xffffffffu);
    const bool writes = it.bench.okay;
    const std::uint32_t mask = it.bench.read32(address);
    if (!it.bench.okay) {
      EXPECT_FALSE(writes) << address;
      ++refused;
    }
    if (!writes) continue;
    EXPECT_EQ(mask & (mask + 1), 0u) << address;
    held += bits(mask);
    const auto word = static_cast<std::uint32_t>(g() >> 32);
    it.bench.write32(address, word);
    EXPECT_EQ(it.bench.read32(address), word & mask) << address;
  }
  constexpr int more = 2 * (32 - 14) + (32 - 4);
  EXPECT_EQ(held, hls::field_width<hls::engine_regs>::value + hls::field_width<hls::normal_map_regs>::value + 32 + more);
  EXPECT_GT(refused, 0);
}

TEST(edge_engine, rtl_equals_hls_on_scenes_back_to_back) {
  work_done done;
  run_back_to_back<session>({{0, 0, 1, 1}, {0, 7, 1, 40}, {7, 0, 1, 40}, {5, 5, 20, 20}}, done);
  EXPECT_GT(done.edge_tests, 1000u);
}

// Registers written while a mesh runs are the next one's.
TEST(edge_engine, registers_are_taken_over_at_start) {
  generator g("shadow");
  session it;
  for (int i = 0; i < 4; ++i) {
    const engine_scene first = good_scene(g), second = good_scene(g);
    it.build_maps(first);
    it.begin(first, 0);
    it.bench.driver.set(second.regs);
    it.send(first);
    it.expect_mesh(first, code::none);
    ASSERT_FALSE(HasFatalFailure()) << "seed " << seed();
  }
}

// And those of a map stay while it is built.
TEST(edge_engine, registers_of_a_map_are_taken_over_with_its_first_texel) {
  generator g("shadow of a map");
  session it;
  engine_scene s(test_map(7, 5, fill::random, g)), other = good_scene(g);
  s.regs.map = s.map.regs(true, false);
  // Slopes of some, not the same on both axes.
  s.normal_regs.gradient_u = hls::from_raw<formats::gradient>(500);
  s.normal_regs.gradient_v = hls::from_raw<formats::gradient>(-300);
  s.build_normals();
  it.bench.driver.set(s.regs);
  it.bench.driver.set(s.normal_regs);
  std::vector<std::uint16_t> const& words = s.map.words();
  it.bench.texels.push_back({words[0], words.size() == 1});
  it.bench.clock(20);
  it.bench.driver.set(other.regs);
  it.bench.driver.set(other.normal_regs);
  for (std::size_t i = 1; i < words.size(); ++i) it.bench.texels.push_back({words[i], i + 1 == words.size()});
  it.wait_for_map();
  it.expect_maps(s);
}

// Not while the last record waits for someone to take it.
TEST(edge_engine, is_done_when_all_has_left) {
  generator g("done");
  session it;
  engine_scene s = first_of(good_scene(g), 1);
  s.regs.pass.max_generation = hls::from_raw<formats::generation>(0);
  it.build_maps(s);
  it.bench.sink_open = false;
  it.begin(s, 1);
  it.send(s);
  it.bench.clock(1000);
  const tb::edge_engine_state state = it.bench.driver.state();
  ASSERT_TRUE(state.busy && !state.done);
  it.bench.sink_open = true;
  it.expect_mesh(s, code::none);
}

// What a watchdog's text begins with.
TEST(edge_engine, names_the_link_that_stopped) {
  generator g("stopped");
  const auto quiet_at = [](session& it, std::string const& link) {
    it.bench.clock(3000);
    EXPECT_GT(it.bench.quiet_clocks(), 1000u) << link;
    EXPECT_EQ(it.bench.stopped().rfind(link, 0), 0u) << it.bench.stopped();
  };
  const engine_scene s = good_scene(g);
  {  // A sink that never takes.
    session it;
    it.build_maps(s);
    it.bench.sink_open = false;
    it.begin(s, 0);
    it.send(s);
    quiet_at(it, "m_axis: a word is not taken");
  }
  {  // Nobody has begun a mesh.
    session it;
    it.send(s);
    quiet_at(it, "s_axis: a word is not taken");
  }
  {  // A packet breaks off.
    session it;
    it.build_maps(s);
    it.begin(s, 0);
    quiet_at(it, "m_axis: nothing comes, and the circuit asks for nothing");
  }
  {  // A new vertex reads the map for its place, from a memory that does not answer.
    session it({0, 0, 1000000, 1000000});
    engine_scene vertices = s;
    vertices.regs.pass.use_sht = vertices.regs.pass.use_pt = false;
    it.build_maps(s);
    it.begin(vertices, 0);
    it.send(vertices);
    quiet_at(it, "place_rsp: an answer does not come");
  }
}

TEST(edge_engine, survives_a_reset_in_the_middle) { reset_in_the_middle<session>({{0, 0, 1, 1}, {4, 6, 1, 40}}); }

}  // namespace
}  // namespace relievo::test
