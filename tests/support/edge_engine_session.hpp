// edge_engine_session: what a host does with the edge engine on its bench: builds maps, runs meshes, and looks at what came.
//   edge_engine_session<Model, Memories> it(traffic)
//   it.build_maps(scene)            both maps through the builders, and their words;  it.run(scene, counted) that and its mesh
//   it.begin(scene, n), .send(scene), .expect_mesh(scene, code)     a mesh in its steps; code: the error that was to be found
//   it.expect_line(code, text)      the driver's line for it
//   first_of(scene, n)              the mesh of its first n base triangles;  good_scene(g) one of three at least
//   run_back_to_back<Session>(patterns, done)   scenes with other registers and maps one after the other, on every pattern of traffic
//   reset_in_the_middle<Session>(patterns)      resets while anything is under way, each with a good scene after it
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "tests/support/edge_engine_bench.hpp"
#include "tests/support/engine_words.hpp"

namespace relievo::test {

// Clocks, or reads of the state, after which something hangs.
constexpr std::uint64_t edge_engine_patience = 20000;

// The mesh of the first n base triangles.
inline engine_scene first_of(engine_scene s, std::size_t n) {
  s.base.resize(n);
  if (n != 0) s.base.back().last = true;
  return s;
}

inline hls_run reference(engine_scene const& s) {
  static const auto engine = std::make_unique<hls::engine<128>>();
  if (!s.base.empty()) return run_hls(*engine, s);
  hls_run nothing;
  hls::triangle_out empty{};
  empty.empty = empty.last = true;
  nothing.triangles.push_back(empty);
  return nothing;
}

template <class Model, class Memories>
class edge_engine_session {
 public:
  explicit edge_engine_session(traffic const& t = {0, 0, 1, 1}) : bench(t) {}

  void build_maps(engine_scene const& s) {
    bench.table.clear();
    bench.normals.clear();
    bench.driver.set(s.regs);
    bench.driver.set(s.normal_regs);
    std::vector<std::uint16_t> const& words = s.map.words();
    for (std::size_t i = 0; i < words.size(); ++i) bench.texels.push_back({words[i], i + 1 == words.size()});
    wait_for_map();
    expect_maps(s);
  }
  void wait_for_map() {
    for (std::uint64_t i = 0; !bench.texels.empty() || bench.driver.state().map_busy; ++i) {
      ASSERT_LT(i, edge_engine_patience) << "the map is not done";
      bench.clock();
    }
  }
  void expect_maps(engine_scene const& s) {
    ASSERT_EQ(bench.table.size(), s.map.words().size());
    ASSERT_EQ(bench.normals.size(), s.map.words().size());
    for (int y = 0; y < s.map.height(); ++y)
      for (int x = 0; x < s.map.width(); ++x) {
        const auto i = static_cast<std::size_t>(y * s.map.width() + x);
        ASSERT_EQ(bench.table[std::make_pair(x, y)], s.map.table().words[i]) << x << ", " << y;
        ASSERT_EQ(bench.normals[std::make_pair(x, y)], s.normals[i]) << x << ", " << y;
      }
  }

  // Registers and start; the packet is the caller's.
  void begin(engine_scene const& s, std::uint32_t expected) {
    bench.load(s);
    bench.packets.clear();
    bench.driver.set(s.regs);
    bench.driver.start(expected);
  }
  void send(engine_scene const& s) {
    for (hls::triangle const& t : s.base) bench.base.push_back({tb::base_of(t), t.last});
  }
  // The mesh is over: one packet, the triangles and counters of s.
  void expect_mesh(engine_scene const& s, tb::edge_engine_code wrong) {
    // Of a mesh that was refused wait() would tell before its packet is swallowed.
    const tb::edge_engine_state state =
        tb::is_refusal(wrong) ? bench.driver.drain(edge_engine_patience) : bench.driver.wait(edge_engine_patience);
    ASSERT_TRUE(state.done);
    ASSERT_EQ(state.code, wrong) << bench.driver.describe(state.code);
    ASSERT_EQ(state.error, wrong != tb::edge_engine_code::none);
    const hls_run right = reference(s);
    ASSERT_EQ(bench.packets.size(), 1u);
    expect_same_set(bench.packets[0], right.triangles);
    if (testing::Test::HasFatalFailure()) return;
    counter_list ours = list_of(bench.driver.counters()), theirs = list_of(right.counts);
    ASSERT_EQ(ours.size(), theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
      // What depends on time.
      if (ours[i].first == "queue_high_water") {
        ASSERT_LE(ours[i].second, bench.driver.build().queue_depth);
      } else if (ours[i].first != "fifo_fallbacks") {
        ASSERT_EQ(ours[i], theirs[i]);
      }
    }
  }
  void run(engine_scene const& s, bool counted) {
    build_maps(s);
    begin(s, counted ? static_cast<std::uint32_t>(s.base.size()) : 0);
    send(s);
    expect_mesh(s, tb::edge_engine_code::none);
    ASSERT_TRUE(bench.idle());
  }
  // The text is one line that says what.
  void expect_line(tb::edge_engine_code wrong, std::string const& part) {
    try {
      bench.driver.check(bench.driver.state());
      FAIL() << "no error, where " << part << " was to be wrong";
    } catch (tb::edge_engine_error const& e) {
      const std::string line = e.what();
      EXPECT_NE(line.find(part), std::string::npos) << line;
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
      EXPECT_EQ(bench.driver.state().code, wrong);
    }
  }

  edge_engine_bench<Model, Memories> bench;
};

// A scene with several base triangles.
inline engine_scene good_scene(generator& g) {
  for (;;) {
    engine_scene s = random_scene(g, static_cast<int>(g.between(0, 3)));
    if (s.base.size() >= 3) return s;
  }
}

struct work_done {
  std::uint64_t edge_tests = 0, profile_samples = 0;
};

template <class Session>
void run_back_to_back(std::vector<traffic> const& patterns, work_done& done) {
  generator g("scenes");
  for (traffic const& t : patterns) {
    Session it(t);
    for (int i = 0; i < 12; ++i) {
      const engine_scene s = random_scene(g, static_cast<int>(g.between(0, 4)));
      it.run(s, i % 2 != 0);
      if (testing::Test::HasFatalFailure()) FAIL() << "scene " << i << ", seed " << seed() << "\n" << describe(s.regs);
      const hls::counters counts = it.bench.driver.counters();
      done.edge_tests += counts.edge_tests;
      done.profile_samples += counts.profile_samples;
    }
  }
}

// Whatever was under way: a mesh, a map, an access of the host, reads of the memories.
template <class Session>
void reset_in_the_middle(std::vector<traffic> const& patterns) {
  generator g("reset");
  for (traffic const& t : patterns) {
    Session it(t);
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
      if (testing::Test::HasFatalFailure()) FAIL() << "reset after " << clocks << " clocks, seed " << seed();
    }
  }
}

}  // namespace relievo::test
