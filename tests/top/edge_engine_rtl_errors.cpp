// edge_engine: every error of a mesh: its code, an end of the packet, and a good mesh after it. Those of a map: edge_engine_rtl_maps.cpp.
#include <gtest/gtest.h>

#include <cstddef>

#include "edge_engine_registers.h"
#include "tests/support/edge_engine_stories.hpp"

namespace relievo::test {
namespace {

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
  refused([](hls::engine_regs& r) { r.pass.max_generation = hls::from_raw<formats::generation>(built_with.max_generation + 1); },
          code::max_generation_too_large,
          "max_generation is " + std::to_string(built_with.max_generation + 1) + ", where this build has " +
              std::to_string(built_with.max_generation) + " at most");
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

// Registers without a circuit: the state is what it is said to be, all else 0.
class only_a_state : public tb::register_bus {
 public:
  explicit only_a_state(std::uint32_t state) : state_(state) {}
  std::uint32_t read32(std::uint32_t address) override { return address == offsetof(edge_engine_t, state) ? state_ : 0; }
  void write32(std::uint32_t, std::uint32_t) override {}

 private:
  std::uint32_t state_;
};

// The credit rule excludes an overflow, so no host and no packet brings the circuit to it: that it reaches the state's code is tested where
// it can be raised (edge_engine_control_rtl.cpp), and here that the host reads a line of it.
TEST(edge_engine, tells_of_an_overflow_of_the_queue) {
  const auto line_of = [](std::uint32_t number) {
    only_a_state registers(EDGE_ENGINE__STATE__DONE_bm | EDGE_ENGINE__STATE__ERROR_bm | number << EDGE_ENGINE__STATE__ERROR_CODE_bp);
    tb::edge_engine_driver driver(registers);
    try {
      driver.check(driver.wait(1));
    } catch (tb::edge_engine_error const& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(line_of(edge_engine_error__queue_overflow),
            "edge engine: the triangle queue overflowed, which its circuit excludes: triangles are missing");
  EXPECT_EQ(line_of(15), "edge engine: error code 15, which this driver does not know");
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
    while (s.base.size() < 1500) s.base.push_back(s.base[s.base.size() % 3]);
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
    it.bench.clock(5000);
    ASSERT_TRUE(it.bench.idle());
    it.bench.driver.clear_error();
  });
}

}  // namespace
}  // namespace relievo::test
