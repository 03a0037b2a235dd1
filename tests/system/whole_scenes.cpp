// Every scene of the list through every model: hls = golden word for word and in order, counters equal, nothing cracked, the queue within
// its bound, and the ideal's decisions on golden's records within the derived margins.
#include <gtest/gtest.h>

#include <algorithm>

#include "golden/edge/redecision_summary.hpp"
#include "golden/surface/summed_area_table.hpp"
#include "tb/analysis/check.hpp"
#include "tb/model/compare.hpp"
#include "tests/system/scenes.hpp"

namespace relievo::test {

namespace {

class whole_scene : public testing::TestWithParam<int> {
 protected:
  named_scene const& named() const { return all_scenes()[static_cast<std::size_t>(GetParam())]; }
};

std::string name_of(testing::TestParamInfo<int> const& info) {
  std::string name = all_scenes()[static_cast<std::size_t>(info.param)].name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

TEST_P(whole_scene, hls_equals_golden) {
  const tb::scene sc = named().make();
  const tb::run_result golden = tb::run_model("golden", sc);
  const tb::run_result hls = tb::run_model("hls", sc);
  ASSERT_FALSE(golden.triangles.empty());
  const tb::comparison c = tb::compare_runs("golden", golden, "hls", hls);
  EXPECT_EQ(c.words_different, 0u) << c.first_difference;
  for (std::string const& line : c.counters_different) ADD_FAILURE() << line;

  const auto most = static_cast<std::uint64_t>(3 * sc.regs.pass.max_generation + 4);
  if (!sc.regs.queue.fifo) {
    EXPECT_LE(hls.counts.queue_high_water, most);
  }
  if (named().in_range) {
    EXPECT_EQ(hls.counts.saturations, 0u);
  }
  EXPECT_EQ(hls.counts.triangles_in, sc.triangles.size());
  EXPECT_EQ(hls.counts.triangles_out, hls.triangles.size());
  EXPECT_TRUE(hls.triangles.back().last);
  if (named().shows) {
    EXPECT_TRUE(named().shows(hls)) << "the scene no longer holds what it is on the list for";
  }
}

TEST_P(whole_scene, is_whole_in_every_model) {
  if (!named().whole) GTEST_SKIP() << "culled on purpose";
  const tb::scene sc = named().make();
  for (char const* model : {"ideal", "golden", "hls"}) {
    const tb::check_report report = tb::check_output(tb::run_model(model, sc).triangles, sc.triangles, sc.regs.map);
    EXPECT_TRUE(report.clean()) << model << "\n" << tb::to_text(report);
    EXPECT_EQ(report.exact, std::string(model) != "hls");
  }
}

TEST_P(whole_scene, ideal_decides_as_golden_but_for_the_margin) {
  const tb::scene sc = named().make();
  const std::vector<std::uint64_t> table = golden::summed_area_table(sc.map.texels.data(), sc.map.width, sc.map.height);
  const golden::redecide redecide(sc.regs, {sc.map.texels.data(), table.data(), sc.normal_map});
  golden::redecision_summary summary;
  tb::run_hooks hooks;
  hooks.traced = [&](golden::edge_trace const& e) { summary.add(e, redecide(e)); };
  const tb::run_result run = tb::run_model("golden", sc, hooks);
  EXPECT_EQ(summary.edges, run.counts.edge_tests);
  // A midpoint at a texel's border, moved by its register: as rare as coordinates that end in half an LSB just below an integer.
  std::printf("%llu edges, %llu middles moved by their register, %llu splits decided otherwise\n",
              static_cast<unsigned long long>(summary.edges), static_cast<unsigned long long>(summary.middles_moved),
              static_cast<unsigned long long>(summary.splits));
  EXPECT_LE(summary.middles_moved, summary.edges / 100 + 1);
  summary.each_test([&](char const* name, golden::test_summary const& t) {
    EXPECT_EQ(t.unexplained, 0u) << name;
    if (t.compared == 0) return;
    std::printf("%-4s %8llu compared, %4llu differ, by at most %.4f %% of the threshold; measures differ by at most %.3g of %.3g derived\n",
                name, static_cast<unsigned long long>(t.compared), static_cast<unsigned long long>(t.differing), 100 * t.largest_share,
                t.largest_change, t.largest_bound);
    EXPECT_LE(t.largest_share, 0.01) << name;
  });
}

INSTANTIATE_TEST_SUITE_P(scenes, whole_scene, testing::Range(0, static_cast<int>(all_scenes().size())), name_of);

}  // namespace

// The paper's FIFO mode puts out the same set of triangles.
TEST(queue_modes, same_set_in_another_order) {
  for (named_scene const& named : all_scenes()) {
    if (named.name != "plane_half-donut" && named.name != "sphere") continue;
    tb::scene sc = named.make();
    const tb::run_result lifo = tb::run_model("hls", sc);
    sc.regs.queue.fifo = true;
    const tb::run_result fifo = tb::run_model("hls", sc);
    const tb::comparison sets = tb::compare_runs("lifo", lifo, "fifo", fifo, false);
    EXPECT_EQ(sets.words_different, 0u) << sets.first_difference;
    EXPECT_NE(tb::compare_runs("lifo", lifo, "fifo", fifo).words_different, 0u) << "the order did not change";
    EXPECT_GT(fifo.counts.queue_high_water, lifo.counts.queue_high_water);
  }
}

// A comparison that cannot fail proves nothing: one bit, one triangle, one counter.
TEST(compare_runs, finds_a_bit_a_triangle_and_a_counter) {
  const tb::scene sc = all_scenes().front().make();
  const tb::run_result golden = tb::run_model("golden", sc);
  tb::run_result broken = golden;
  broken.triangles[3].v[1].displaced_n.y += 1.0 / (1 << formats::unit::fraction);
  const tb::comparison bit = tb::compare_runs("golden", golden, "broken", broken);
  EXPECT_EQ(bit.words_different, 1u);
  EXPECT_NE(bit.first_difference.find("v[1].displaced_n"), std::string::npos) << bit.first_difference;
  broken = golden;
  broken.triangles.pop_back();
  EXPECT_FALSE(tb::compare_runs("golden", golden, "broken", broken).equal());
  broken = golden;
  ++broken.counts.edge_tests;
  EXPECT_EQ(tb::compare_runs("golden", golden, "broken", broken).counters_different.size(), 1u);
  broken = golden;
  broken.triangles[0].v[0].u.x += 1e-9;
  EXPECT_FALSE(tb::compare_runs("golden", golden, "broken", broken).equal()) << "a value that is no word went unnoticed";
}

}  // namespace relievo::test
