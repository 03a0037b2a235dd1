// engine: hls equals golden, every output word in order and every counter, on random scenes with the smallest queue that works; the
// worst descent at the largest generation; last and empty; meshes back to back.
#include "hls/edge/engine.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/engine_scene.hpp"

namespace relievo::test {
namespace {

hls::fixed<formats::generation> generation(int g) { return hls::from_raw<formats::generation>(g); }

// One record last, and it is the last one; empty only when nothing else came out.
void expect_one_last(hls_run const& run) {
  ASSERT_FALSE(run.triangles.empty());
  for (std::size_t i = 0; i < run.triangles.size(); ++i) {
    ASSERT_EQ(run.triangles[i].last, i + 1 == run.triangles.size()) << "record " << i;
    ASSERT_EQ(run.triangles[i].empty, run.counts.triangles_out == 0) << "record " << i;
  }
}

// What the counters owe each other.
void expect_balanced(hls_run const& run, engine_scene const& s) {
  hls::counters const& c = run.counts;
  const std::uint64_t passes = c.splits[0] + c.splits[1] + c.splits[2] + c.splits[3];
  const std::uint64_t split_edges = c.splits[1] + 2 * c.splits[2] + 3 * c.splits[3];
  EXPECT_EQ(c.triangles_in, s.base.size());
  EXPECT_EQ(c.edge_tests + c.settled_skips, 3 * passes);
  EXPECT_EQ(c.triangles_out + c.culled, c.splits[0]);
  EXPECT_EQ(passes, c.triangles_in + split_edges + c.splits[1] + c.splits[2] + c.splits[3]);
  EXPECT_EQ(c.vertices, 3 * c.triangles_in + split_edges);
  EXPECT_EQ(run.triangles.size(), c.triangles_out + (c.triangles_out == 0 ? 1 : 0));
  EXPECT_EQ(c.table_reads % 12, 0u);
}

TEST(engine, hls_equals_golden_on_random_scenes) {
  const auto tiny = std::make_unique<hls::engine<4>>();
  const auto small = std::make_unique<hls::engine<10>>();
  const auto medium = std::make_unique<hls::engine<19>>();
  const auto large = std::make_unique<hls::engine<100>>();
  generator g("scenes");
  counter_list seen = list_of(hls::counters());
  std::uint64_t scenes = 0;
  for (std::uint64_t tests = 0; tests < vector_count() / 2 || scenes < 300; ++scenes) {
    const int max_generation = static_cast<int>(g.between(0, 5));
    const engine_scene s = random_scene(g, max_generation);
    const int depth = g.chance(4) ? 100 : max_generation == 0 ? 4 : max_generation <= 2 ? 10 : 19;
    const hls_run run = depth == 4    ? run_hls(*tiny, s)
                        : depth == 10 ? run_hls(*small, s)
                        : depth == 19 ? run_hls(*medium, s)
                                      : run_hls(*large, s);
    ASSERT_TRUE(equal_runs(run, run_golden(s, static_cast<std::size_t>(depth))))
        << "scene " << scenes << ", seed " << seed() << ", queue of " << depth << "\n"
        << describe(s.regs);
    expect_one_last(run);
    expect_balanced(run, s);
    if (HasFailure()) FAIL() << "scene " << scenes << ", seed " << seed();
    const counter_list counts = list_of(run.counts);
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i].second += counts[i].second;
    tests += run.counts.edge_tests + 10;
  }
  for (auto const& counter : seen) EXPECT_GT(counter.second, 0u) << "no scene made " << counter.first << " count";
}

// Everything wants to split, and an edge is short on the screen unless it is long for its distance from one corner: the mesh refines
// towards that corner as deep as generations go.
engine_scene descent(int max_generation, bool fifo) {
  generator g("descent");
  engine_scene s(test_map(8, 8, fill::random, g));
  s.regs.map = s.map.regs(false, false);
  s.calm_camera();
  // w = x + y + 2 + 2^-12, x and y from -1.
  for (int i = 0; i < 2; ++i) s.regs.transform.row_w[i] = hls::from_raw<formats::matrix_w>(std::int64_t(1) << formats::matrix_w::fraction);
  s.regs.transform.offset_w = hls::from_raw<formats::offset_w>((std::int64_t(2) << formats::offset_w::fraction) + (std::int64_t(1) << 32));
  s.regs.transform.w_min = hls::from_raw<formats::depth>(1);
  for (auto* row : {s.regs.transform.row_x, s.regs.transform.row_y})
    for (int i = 0; i < 2; ++i)
      if (raw(row[i]) != 0) row[i] = hls::from_raw<formats::matrix_xy>(std::int64_t(100) << formats::matrix_xy::fraction);
  s.regs.transform.offset_x = s.regs.transform.offset_y =
      hls::from_raw<formats::offset_xy>(std::int64_t(100) << formats::offset_xy::fraction);
  s.regs.highlight.threshold = hls::from_raw<formats::unit>(-32768);
  s.regs.pass.use_ht = s.regs.pass.use_vt = true;
  s.regs.pass.max_generation = generation(max_generation);
  s.regs.view.threshold = hls::from_raw<formats::view_threshold>(40 << formats::view_threshold::fraction);
  s.regs.queue.fifo = fifo;
  s.build_normals();
  s.add_plane(1, 1);
  return s;
}

TEST(engine, hls_equals_golden_down_to_the_last_generation) {
  const auto engine = std::make_unique<hls::engine<3 * 15 + 4>>();
  for (const bool fifo : {false, true}) {
    const engine_scene s = descent(15, fifo);
    const hls_run run = run_hls(*engine, s);
    ASSERT_TRUE(equal_runs(run, run_golden(s, 49))) << "fifo " << fifo;
    expect_one_last(run);
    expect_balanced(run, s);
    EXPECT_GT(run.counts.splits[3], 2 * 10u) << "the mesh was to refine towards its corner";
    EXPECT_EQ(run.counts.fifo_fallbacks > 0, fifo);
  }
}

// Every edge splits to generation 15: 4^15 triangles, of which the first tens of thousands will do. Depth first, the first descent leaves
// three triangles behind at each generation.
template <int Depth>
void expect_room_for_full_splits(bool fifo, std::size_t outputs) {
  struct enough {};
  engine_scene s = descent(15, fifo);
  s.regs.pass.use_vt = false;
  const auto engine = std::make_unique<hls::engine<Depth>>();
  hls_run run;
  hls::stream<hls::triangle, 1> in("engine.in");
  hls::stream<hls::triangle_out, 2> out("engine.out");
  engine->start();
  in.write(s.base[0]);
  while (run.triangles.size() < outputs) {
    engine->step(in, out, s.regs, {s.map.texels(), s.map.table(), {s.normals.data()}});
    ASSERT_LE(engine->counts().queue_high_water, static_cast<std::uint64_t>(Depth));
    while (!out.empty()) run.triangles.push_back(out.read());
  }
  std::vector<golden::triangle_out> right;
  golden::engine<golden::rounded> golden_engine(
      as_golden<golden::engine_regs>(s.regs),
      {s.map.texels().words, s.map.table().words, as_golden<golden::normal_map_regs>(s.normal_regs)}, Depth);
  const auto next = [&](golden::triangle& t) {
    t = as_golden<golden::triangle>(s.base[0]);
    return true;
  };
  const auto put = [&](golden::triangle_out const& t) {
    right.push_back(t);
    if (right.size() == outputs) throw enough();
  };
  EXPECT_THROW(golden_engine.run(next, put), enough);
  for (std::size_t i = 0; i < outputs; ++i) ASSERT_TRUE(equal_words(run.triangles[i], right[i])) << "record " << i;
  if (fifo) {
    EXPECT_GT(engine->counts().fifo_fallbacks, 0u);
  } else {
    EXPECT_EQ(engine->counts().queue_high_water, 3 * 15 + 1u);
  }
}

TEST(engine, the_smallest_queue_holds_a_triangle_that_splits_everywhere) {
  expect_room_for_full_splits<49>(false, 20000);
  expect_room_for_full_splits<49>(true, 2000);
  expect_room_for_full_splits<200>(true, 2000);
}

TEST(engine, without_generations_base_triangles_are_passed) {
  const auto engine = std::make_unique<hls::engine<4>>();
  const engine_scene s = descent(0, false);
  const hls_run run = run_hls(*engine, s);
  ASSERT_TRUE(equal_runs(run, run_golden(s, 4)));
  EXPECT_EQ(run.counts.edge_tests, 0u);
  EXPECT_EQ(run.counts.settled_skips, 6u);
  EXPECT_EQ(run.triangles.size(), 2u);
}

TEST(engine, a_mesh_culled_whole_leaves_one_empty_record) {
  const auto engine = std::make_unique<hls::engine<19>>();
  engine_scene s = descent(3, false);
  s.regs.pass.cull = true;
  // Below the plane, and no map normal turns by a right angle here.
  s.normal_regs = {};
  s.build_normals();
  s.regs.transform_normal.eye[2] = hls::from_raw<formats::eye>(-(std::int64_t(2) << formats::eye::fraction));
  const hls_run run = run_hls(*engine, s);
  ASSERT_TRUE(equal_runs(run, run_golden(s, 19)));
  ASSERT_EQ(run.triangles.size(), 1u);
  EXPECT_TRUE(run.triangles[0].empty && run.triangles[0].last);
  EXPECT_EQ(run.counts.triangles_out, 0u);
  EXPECT_GT(run.counts.culled, 2u);
  // From above, the same mesh is all there.
  s.regs.transform_normal.eye[2] = hls::from_raw<formats::eye>(std::int64_t(2) << formats::eye::fraction);
  const hls_run above = run_hls(*engine, s);
  EXPECT_EQ(above.counts.culled, 0u);
  EXPECT_EQ(above.counts.triangles_out, run.counts.culled);
}

TEST(engine, a_mesh_after_another_is_as_if_alone) {
  const auto used = std::make_unique<hls::engine<49>>();
  generator g("back to back");
  for (int i = 0; i < 40; ++i) {
    const engine_scene s = i % 8 == 0 ? descent(6, i % 16 == 0) : random_scene(g, static_cast<int>(g.between(0, 4)));
    const auto fresh = std::make_unique<hls::engine<49>>();
    const hls_run again = run_hls(*used, s), alone = run_hls(*fresh, s);
    ASSERT_EQ(again.triangles.size(), alone.triangles.size()) << "mesh " << i;
    for (std::size_t k = 0; k < alone.triangles.size(); ++k)
      ASSERT_TRUE(same_words(again.triangles[k], alone.triangles[k])) << "mesh " << i << ", record " << k;
    ASSERT_EQ(list_of(again.counts), list_of(alone.counts)) << "mesh " << i;
  }
}

// The order of the queue does not change what comes out, only when.
TEST(engine, both_orders_of_the_queue_give_the_same_set) {
  const auto engine = std::make_unique<hls::engine<100>>();
  generator g("orders");
  for (int i = 0; i < 20; ++i) {
    engine_scene s = random_scene(g, 4);
    std::vector<std::vector<std::int64_t>> sets[2];
    for (const bool fifo : {false, true}) {
      s.regs.queue.fifo = fifo;
      for (hls::triangle_out t : run_hls(*engine, s).triangles) {
        t.last = false;
        sets[fifo ? 1 : 0].push_back(tb::raw_words(t));
      }
    }
    for (auto& set : sets) std::sort(set.begin(), set.end());
    ASSERT_EQ(sets[0], sets[1]) << "scene " << i;
  }
}

}  // namespace
}  // namespace relievo::test
