// edge_engine_control: its clocks, and what the whole engine cannot be brought to do: an overflow of its queue, and errors that come
// together. All else is tested through the buses (tests/top/edge_engine_rtl.cpp).
#include <gtest/gtest.h>

#include "Vedge_engine_control.h"
#include "hls/edge/engine_regs.hpp"
#include "tb/cosim/edge_engine_driver.hpp"
#include "tb/cosim/ports.hpp"
#include "tb/cosim/ports_of_lanes.hpp"
#include "tests/support/clocked_model.hpp"

namespace relievo::test {
namespace {

using code = tb::edge_engine_code;
// As a port has it.
constexpr int number(code c) { return static_cast<int>(c); }
enum control { start = 1, stop = 2, clear_error = 4 };

class control_bench {
 public:
  control_bench() {
    hls::engine_regs regs{};
    regs.map.width = regs.map.height = hls::from_raw<formats::map_size>(4);
    set(regs);
    model().max_generation_i = 6;
    model().control_i = 0;
    model().expected_i = 0;
    model().engine_done_i = 1;
    model().input_over_i = 1;
    model().overflow_i = model().memory_error_i = model().generation_beyond_i = 0;
    model().input_error_i = model().map_error_i = number(code::none);
    model_.reset();
  }
  void set(hls::engine_regs const& regs) { tb::put(model().regs_i, regs); }
  void clock() { model_.clock(); }
  void write(int word) {
    model().control_i = static_cast<CData>(word);
    clock();
    model().control_i = 0;
    model_.settle();
  }
  // A mesh begins; the engine and its input are at work until finish().
  void begin() {
    write(start);
    for (int i = 0; i < 8; ++i) {
      if (model().begin_o) model().engine_done_i = model().input_over_i = 0;
      clock();
    }
    ASSERT_TRUE(model().busy_o);
    ASSERT_FALSE(model().done_o);
  }
  void finish() {
    model().engine_done_i = model().input_over_i = 1;
    clock();
    clock();
    ASSERT_FALSE(model().busy_o);
    ASSERT_TRUE(model().done_o);
  }
  Vedge_engine_control& model() { return *model_; }
  clocked_model<Vedge_engine_control>& clocks() { return model_; }

 private:
  clocked_model<Vedge_engine_control> model_;
};

// Every clock from the host's write of start to begin, and from the engine's end to done.
TEST(edge_engine_control, begins_two_clocks_after_the_start_and_is_done_one_after_the_end) {
  control_bench bench;
  Vedge_engine_control& m = bench.model();
  for (int i = 0; i < 3; ++i) {
    hls::engine_regs regs{};
    regs.map.width = regs.map.height = hls::from_raw<formats::map_size>(5 + i);
    bench.set(regs);
    m.control_i = start;
    bench.clocks().settle();
    EXPECT_TRUE(m.close_o) << "at once";
    bench.write(start);
    EXPECT_FALSE(m.close_o);
    EXPECT_TRUE(m.busy_o);
    EXPECT_FALSE(m.done_o);
    EXPECT_FALSE(m.begin_o);
    EXPECT_EQ(hls::pack(tb::get<hls::engine_regs>(m.regs_o)), hls::pack(regs));
    bench.clock();
    EXPECT_TRUE(m.begin_o);
    const auto limit = static_cast<std::uint64_t>(4 + i) << formats::coordinate::fraction;
    EXPECT_EQ(tb::get_bits<64>(m.limit_o, 0, formats::coordinate::width).limb[0], limit);
    m.engine_done_i = m.input_over_i = 0;
    bench.clock();
    EXPECT_FALSE(m.begin_o) << "for one clock";
    bench.clock();
    // It runs now: a stop goes on in the next clock.
    bench.write(stop);
    EXPECT_TRUE(m.stop_o);
    bench.clock();
    EXPECT_FALSE(m.stop_o) << "for one clock";
    m.map_error_i = number(code::map_early_last);
    bench.clock();
    m.map_error_i = number(code::none);
    EXPECT_EQ(m.error_code_o, number(code::map_early_last));
    m.engine_done_i = m.input_over_i = 1;
    bench.clocks().settle();
    EXPECT_FALSE(m.done_o);
    bench.clock();
    EXPECT_TRUE(m.done_o);
    EXPECT_FALSE(m.busy_o);
  }
}

TEST(edge_engine_control, reports_an_overflow_of_the_queue) {
  control_bench bench;
  bench.begin();
  // It stays until the next start.
  bench.model().overflow_i = 1;
  bench.clock();
  EXPECT_EQ(bench.model().error_code_o, number(code::queue_overflow));
  EXPECT_TRUE(bench.model().busy_o);
  bench.finish();
  EXPECT_EQ(bench.model().error_code_o, number(code::queue_overflow));
  bench.write(clear_error);
  bench.clock();
  EXPECT_EQ(bench.model().error_code_o, number(code::none)) << "one overflow is reported once";
  bench.model().overflow_i = 0;
  bench.begin();
  bench.finish();
  EXPECT_EQ(bench.model().error_code_o, number(code::none));
}

TEST(edge_engine_control, keeps_the_first_error) {
  control_bench bench;
  bench.begin();
  bench.model().input_error_i = number(code::early_last);
  bench.clock();
  bench.model().input_error_i = number(code::none);
  bench.model().map_error_i = number(code::map_early_last);
  bench.clock();
  bench.model().map_error_i = number(code::none);
  bench.write(start);
  EXPECT_EQ(bench.model().error_code_o, number(code::early_last));
  bench.finish();
  EXPECT_EQ(bench.model().error_code_o, number(code::early_last));
  // An error that comes while the last one is cleared is not lost.
  bench.model().map_error_i = number(code::map_early_last);
  bench.write(clear_error);
  EXPECT_EQ(bench.model().error_code_o, number(code::map_early_last));
}

TEST(edge_engine_control, a_start_clears_the_last_error_and_says_its_own) {
  control_bench bench;
  bench.begin();
  bench.write(start);
  EXPECT_EQ(bench.model().error_code_o, number(code::start_while_busy));
  bench.finish();
  hls::engine_regs regs{};
  regs.map.width = regs.map.height = hls::from_raw<formats::map_size>(4);
  regs.pass.max_generation = hls::from_raw<formats::generation>(7);
  bench.set(regs);
  bench.write(start);
  EXPECT_EQ(bench.model().error_code_o, number(code::max_generation_too_large));
  EXPECT_TRUE(bench.model().busy_o) << "known as soon as the mesh is";
  EXPECT_TRUE(bench.model().refuse_o);
}

// A stop that is written right after the start waits for the mesh to run; one without a mesh is for nobody.
TEST(edge_engine_control, passes_a_stop_on_once) {
  for (int wait = 0; wait < 6; ++wait) {
    control_bench bench;
    bench.write(stop);
    bench.begin();
    bench.finish();
    bench.write(start);
    int stops = 0, begins = 0;
    for (int i = 0; i < 20; ++i) {
      bench.model().control_i = i == wait ? stop : 0;
      bench.model().engine_done_i = bench.model().input_over_i = begins != 0 && i > 12;
      bench.clock();
      begins += bench.model().begin_o;
      stops += bench.model().stop_o;
    }
    EXPECT_EQ(begins, 1) << wait;
    EXPECT_EQ(stops, 1) << wait;
    EXPECT_TRUE(bench.model().done_o) << wait;
  }
}

}  // namespace
}  // namespace relievo::test
