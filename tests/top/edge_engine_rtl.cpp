// verilate: Vedge_engine SAT_READS_PER_CLOCK=3 PROFILE_SAMPLES_PER_CLOCK=1 QUEUE_DEPTH=128 MAX_GENERATION=6
// edge_engine: the circuit through its buses, maps built by its builders, meshes back to back with other registers: the triangles and
// counters of hls::engine. And every error: its code, an end of the packet, and a good mesh after it.
#include <gtest/gtest.h>

#include <cstddef>

#include "Vedge_engine.h"
#include "edge_engine_registers.h"
#include "tests/support/edge_engine_session.hpp"

namespace relievo::test {
namespace {

using session = edge_engine_session<Vedge_engine>;
using code = tb::edge_engine_code;
constexpr int max_generation = 6;

TEST(edge_engine, says_what_it_was_built_with) {
  session it;
  const tb::edge_engine_build b = it.bench.driver.build();
  EXPECT_EQ(b.lanes, 1u);
  EXPECT_EQ(b.sat_reads_per_clock, 3u);
  EXPECT_EQ(b.profile_samples_per_clock, 1u);
  EXPECT_EQ(b.queue_depth, 128u);
  EXPECT_EQ(b.max_generation, static_cast<std::uint32_t>(max_generation));
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
  generator g("scenes");
  const traffic patterns[] = {{0, 0, 1, 1}, {0, 7, 1, 40}, {7, 0, 1, 40}, {5, 5, 20, 20}};
  std::uint64_t tests = 0;
  for (traffic const& t : patterns) {
    session it(t);
    for (int i = 0; i < 12; ++i) {
      const engine_scene s = random_scene(g, static_cast<int>(g.between(0, 4)));
      it.run(s, i % 2 != 0);
      if (HasFatalFailure()) FAIL() << "scene " << i << ", seed " << seed() << "\n" << describe(s.regs);
      tests += it.bench.driver.counters().edge_tests;
    }
  }
  EXPECT_GT(tests, 1000u);
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

// Whatever was under way: a mesh, a map, an access of the host, reads of the memories.
TEST(edge_engine, survives_a_reset_in_the_middle) {
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

// ---- errors: each as a story of its own, on a bench that has run, and that runs a good scene afterwards
template <class Story>
void tell(Story story) {
  for (traffic const& t : {traffic{0, 0, 1, 1}, traffic{6, 4, 1, 20}}) {
    session it(t);
    generator g("errors");
    it.run(good_scene(g), true);
    const engine_scene s = good_scene(g);
    story(it, s);
    if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed();
    it.run(good_scene(g), true);
    if (testing::Test::HasFatalFailure()) FAIL() << "the good scene afterwards, seed " << seed();
  }
}

// A start that is refused, and its packet, which comes or does not.
template <class Spoil>
void refused(Spoil spoil, code wrong, std::string const& part) {
  for (const bool comes : {true, false})
    for (const bool counted : {true, false})
      tell([&](session& it, engine_scene s) {
        spoil(s.regs);
        it.begin(s, counted ? static_cast<std::uint32_t>(s.base.size()) : 0);
        const tb::edge_engine_state state = it.bench.driver.state();
        ASSERT_TRUE(state.busy && state.error && !state.done);
        it.expect_line(wrong, part);
        if (comes)
          it.send(s);
        else
          it.bench.driver.stop();
        it.expect_mesh(first_of(s, 0), wrong);
        ASSERT_TRUE(it.bench.idle());
      });
}

TEST(edge_engine, refuses_a_map_size_of_zero) {
  refused([](hls::engine_regs& r) { r.map.width = hls::from_raw<formats::map_size>(0); }, code::map_size_zero, "0 x ");
  refused([](hls::engine_regs& r) { r.map.height = hls::from_raw<formats::map_size>(0); }, code::map_size_zero, " x 0");
}
TEST(edge_engine, refuses_a_map_size_beyond_the_format) {
  refused([](hls::engine_regs& r) { r.map.width = hls::from_raw<formats::map_size>(8193); }, code::map_size_too_large, "8193 x ");
  refused([](hls::engine_regs& r) { r.map.height = hls::from_raw<formats::map_size>(16383); }, code::map_size_too_large, " x 16383");
}
// What the records have no room for, which would come out as something harmless when its upper bits were lost.
TEST(edge_engine, refuses_what_its_records_cannot_hold) {
  struct {
    std::uint32_t address, word;
    code wrong;
    char const* part;
  } const cases[] = {{offsetof(edge_engine_t, engine_regs.map.width), 16384 + 4, code::map_size_too_large, "16388 x "},
                     {offsetof(edge_engine_t, engine_regs.map.height), 20480, code::map_size_too_large, " x 20480"},
                     {offsetof(edge_engine_t, engine_regs.pass.max_generation), 17, code::max_generation_too_large, "max_generation is 17"},
                     {offsetof(edge_engine_t, engine_regs.pass.max_generation), 0x80000000u, code::max_generation_too_large, "2147483648"}};
  for (auto const& c : cases)
    tell([&](session& it, engine_scene const& s) {
      it.bench.driver.set(s.regs);
      it.bench.write32(c.address, c.word);
      it.bench.load(s);
      it.bench.packets.clear();
      it.bench.driver.start(0);
      it.send(s);
      it.expect_mesh(first_of(s, 0), c.wrong);
      it.expect_line(c.wrong, c.part);
      it.bench.driver.clear_error();
    });
}
TEST(edge_engine, refuses_a_max_generation_above_the_builds) {
  refused([](hls::engine_regs& r) { r.pass.max_generation = hls::from_raw<formats::generation>(max_generation + 1); },
          code::max_generation_too_large, "max_generation is 7, where this build has 6");
}

TEST(edge_engine, survives_an_early_last) {
  tell([](session& it, engine_scene const& s) {
    it.begin(s, static_cast<std::uint32_t>(s.base.size() + 2));
    it.send(s);
    it.expect_mesh(s, code::early_last);
    it.expect_line(code::early_last, "came after " + std::to_string(s.base.size()));
  });
}

// The packet ends without saying so, or goes on.
TEST(edge_engine, survives_a_missing_last) {
  for (const std::size_t more : {0, 1, 5})
    tell([&](session& it, engine_scene s) {
      const engine_scene whole = s;
      s.base.back().last = false;
      for (std::size_t i = 0; i < more; ++i) {
        s.base.push_back(s.base.front());
        s.base.back().last = i + 1 == more;
      }
      it.begin(s, static_cast<std::uint32_t>(whole.base.size()));
      it.send(s);
      it.expect_mesh(whole, code::missing_last);
      it.expect_line(code::missing_last, "without last and tlast");
      it.bench.clock(200);
      ASSERT_TRUE(it.bench.idle());
      ASSERT_EQ(it.bench.driver.state().swallowing, more == 0);
    });
}

// The mesh waits for the rest of its packet only where the count says that there is one.
TEST(edge_engine, survives_last_and_tlast_that_disagree) {
  for (const bool tlast : {true, false})
    for (const bool counted : {true, false})
      for (const std::size_t at : {0, 1, 2})
        tell([&](session& it, engine_scene const& s) {
          it.begin(s, counted ? static_cast<std::uint32_t>(s.base.size()) : 0);
          const auto offer = [&](std::size_t i) {
            hls::top::base_triangle b = base_of(s.base[i]);
            b.last = i == at ? !tlast : false;
            it.bench.base.push_back({b, i == at ? tlast : i + 1 == s.base.size()});
          };
          for (std::size_t i = 0; i <= at; ++i) offer(i);
          it.bench.clock(5000);
          ASSERT_EQ(it.bench.driver.state().busy, !tlast && counted && at + 1 < s.base.size());
          if (!tlast)
            for (std::size_t i = at + 1; i < s.base.size(); ++i) offer(i);
          it.expect_mesh(first_of(s, at + 1), code::last_disagrees);
          it.expect_line(code::last_disagrees, "only one of last and tlast");
          it.bench.clock(200);
          ASSERT_TRUE(it.bench.idle());
        });
}

TEST(edge_engine, survives_a_coordinate_outside_the_map) {
  for (const std::size_t at : {0, 1, 2})
    for (int vertex = 0; vertex < 3; ++vertex)
      for (int axis = 0; axis < 2; ++axis)
        tell([&](session& it, engine_scene s) {
          const engine_scene before = first_of(s, at);
          const std::int64_t limit =
              axis == 0 ? coordinate_limit(s.regs.map.width, s.regs.map.wrap_u) : coordinate_limit(s.regs.map.height, s.regs.map.wrap_v);
          s.base[at].v[vertex].u[axis] = hls::from_raw<formats::coordinate>(limit + 1);
          it.begin(s, at == 1 ? static_cast<std::uint32_t>(s.base.size()) : 0);
          it.send(s);
          it.expect_mesh(before, code::coordinate_outside_map);
          it.expect_line(code::coordinate_outside_map, "after " + std::to_string(at) + " has a texture coordinate outside");
          ASSERT_TRUE(it.bench.idle());
        });
}

// On the last record by the count, which has no tlast either: nothing more is waited for.
TEST(edge_engine, survives_a_coordinate_outside_the_map_and_a_missing_last) {
  tell([](session& it, engine_scene s) {
    const engine_scene before = first_of(s, s.base.size() - 1);
    s.base.back().last = false;
    s.base.back().v[1].u[0] = hls::from_raw<formats::coordinate>(hls::fixed<formats::coordinate>::max_raw);
    it.begin(s, static_cast<std::uint32_t>(s.base.size()));
    it.send(s);
    it.expect_mesh(before, code::coordinate_outside_map);
  });
}

TEST(edge_engine, survives_a_start_while_busy) {
  tell([](session& it, engine_scene const& s) {
    it.bench.sink_open = false;
    it.begin(s, 0);
    it.send(s);
    it.bench.clock(300);
    it.bench.driver.start(1);
    it.expect_line(code::start_while_busy, "while a mesh was running");
    it.bench.sink_open = true;
    it.expect_mesh(s, code::start_while_busy);
    it.bench.driver.clear_error();
    ASSERT_FALSE(it.bench.driver.state().error);
  });
}

// The mesh goes on; the host learns of it.
TEST(edge_engine, tells_of_a_memory_that_fails) {
  tell([](session& it, engine_scene const& s) {
    it.begin(s, 0);
    it.bench.memories.error_next = true;
    it.send(s);
    it.expect_mesh(s, code::memory_error);
    it.expect_line(code::memory_error, "a map memory answered");
    it.bench.driver.clear_error();
  });
}

TEST(edge_engine, survives_a_packet_that_breaks_off) {
  for (const std::size_t sent : {0, 1, 2})
    tell([&](session& it, engine_scene const& s) {
      it.begin(s, sent == 2 ? static_cast<std::uint32_t>(s.base.size()) : 0);
      for (std::size_t i = 0; i < sent; ++i) it.bench.base.push_back({base_of(s.base[i]), false});
      it.bench.clock(500);
      EXPECT_THROW(it.bench.driver.wait(10), tb::edge_engine_error);
      it.bench.driver.stop();
      it.expect_mesh(first_of(s, sent), code::stopped);
      it.expect_line(code::stopped, "stop was written");
    });
}

// The records that were taken are of the mesh, the one that waits for the engine among them: with the sink closed the engine takes so many.
TEST(edge_engine, stops_behind_the_record_that_waits) {
  tell([](session& it, engine_scene s) {
    s.regs.pass.max_generation = hls::from_raw<formats::generation>(0);
    s.regs.pass.cull = false;
    while (s.base.size() < 60) s.base.push_back(s.base[s.base.size() % 3]);
    for (hls::triangle& t : s.base) t.last = false;
    it.bench.sink_open = false;
    it.begin(s, 0);
    it.send(s);
    it.bench.clock(5000);
    const std::size_t taken = s.base.size() - it.bench.base.size();
    ASSERT_LT(taken, s.base.size()) << "nothing waits";
    it.bench.driver.stop();
    it.bench.clock(100);
    it.bench.sink_open = true;
    it.expect_mesh(first_of(s, taken), code::stopped);
    // What follows is of no packet, and swallowed.
    it.bench.clock(500);
    ASSERT_TRUE(it.bench.idle());
    it.bench.driver.clear_error();
  });
}

// ---- errors of a map; the builders still put out a whole map of some kind, or nothing
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

// The host may have seen it while the last row is still coming out; then nothing is swallowed.
TEST(edge_engine, forgets_the_rest_of_a_map_that_the_host_has_seen_before_it_was_out) {
  session it;
  generator g("flush");
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

}  // namespace
}  // namespace relievo::test
