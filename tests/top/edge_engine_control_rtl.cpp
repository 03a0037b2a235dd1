// edge_engine_control: what the whole engine cannot be brought to do: an overflow of its queue, and errors that come together. All else is
// tested through the buses (tests/top/edge_engine_rtl.cpp).
#include <gtest/gtest.h>

#include <memory>

#include "Vedge_engine_control.h"
#include "hls/edge/engine_regs.hpp"
#include "tb/cosim/coverage.hpp"
#include "tb/cosim/ports.hpp"
#include "tests/support/settings.hpp"

namespace relievo::test {
namespace {

// The numbers of rtl/top/edge_engine_pkg.sv.
enum code { none = 0, max_generation_too_large = 3, early_last = 4, start_while_busy = 8, queue_overflow = 9, map_early_last = 10 };
enum control { start = 1, stop = 2, clear_error = 4 };

class control_bench {
 public:
  control_bench() {
    context_.randReset(2);
    context_.randSeed(static_cast<int>(seed() & 0x7fffffff) + 1);
    model_ = std::make_unique<Vedge_engine_control>(&context_);
    hls::engine_regs regs{};
    regs.map.width = regs.map.height = hls::from_raw<formats::map_size>(4);
    set(regs);
    model_->clk_i = 0;
    model_->max_generation_i = 6;
    model_->control_i = 0;
    model_->expected_i = 0;
    model_->engine_done_i = 1;
    model_->input_over_i = 1;
    model_->overflow_i = model_->memory_error_i = model_->generation_beyond_i = 0;
    model_->input_error_i = model_->map_error_i = none;
    model_->rst_ni = 0;
    for (int i = 0; i < 4; ++i) clock();
    model_->rst_ni = 1;
    clock();
  }
  void set(hls::engine_regs const& regs) { tb::put(model_->regs_i, regs); }
  void clock() {
    model_->eval();
    model_->clk_i = 1;
    model_->eval();
    model_->clk_i = 0;
    model_->eval();
  }
  void write(int word) {
    model_->control_i = static_cast<CData>(word);
    clock();
    model_->control_i = 0;
  }
  // A mesh begins; the engine and its input are at work until finish().
  void begin() {
    write(start);
    for (int i = 0; i < 8; ++i) {
      if (model_->begin_o) model_->engine_done_i = model_->input_over_i = 0;
      clock();
    }
    ASSERT_TRUE(model_->busy_o);
    ASSERT_FALSE(model_->done_o);
  }
  void finish() {
    model_->engine_done_i = model_->input_over_i = 1;
    clock();
    clock();
    ASSERT_FALSE(model_->busy_o);
    ASSERT_TRUE(model_->done_o);
  }
  Vedge_engine_control& model() { return *model_; }

 private:
  VerilatedContext context_;
  std::unique_ptr<Vedge_engine_control> model_;
  const tb::keep_coverage kept_{context_};
};

TEST(edge_engine_control, reports_an_overflow_of_the_queue) {
  control_bench bench;
  bench.begin();
  // It stays until the next start.
  bench.model().overflow_i = 1;
  bench.clock();
  EXPECT_EQ(bench.model().error_code_o, queue_overflow);
  EXPECT_TRUE(bench.model().busy_o);
  bench.finish();
  EXPECT_EQ(bench.model().error_code_o, queue_overflow);
  bench.write(clear_error);
  bench.clock();
  EXPECT_EQ(bench.model().error_code_o, none) << "one overflow is reported once";
  bench.model().overflow_i = 0;
  bench.begin();
  bench.finish();
  EXPECT_EQ(bench.model().error_code_o, none);
}

TEST(edge_engine_control, keeps_the_first_error) {
  control_bench bench;
  bench.begin();
  bench.model().input_error_i = early_last;
  bench.clock();
  bench.model().input_error_i = none;
  bench.model().map_error_i = map_early_last;
  bench.clock();
  bench.model().map_error_i = none;
  bench.write(start);
  EXPECT_EQ(bench.model().error_code_o, early_last);
  bench.finish();
  EXPECT_EQ(bench.model().error_code_o, early_last);
  // An error that comes while the last one is cleared is not lost.
  bench.model().map_error_i = map_early_last;
  bench.write(clear_error);
  EXPECT_EQ(bench.model().error_code_o, map_early_last);
}

TEST(edge_engine_control, a_start_clears_the_last_error_and_says_its_own) {
  control_bench bench;
  bench.begin();
  bench.write(start);
  EXPECT_EQ(bench.model().error_code_o, start_while_busy);
  bench.finish();
  hls::engine_regs regs{};
  regs.map.width = regs.map.height = hls::from_raw<formats::map_size>(4);
  regs.pass.max_generation = hls::from_raw<formats::generation>(7);
  bench.set(regs);
  bench.write(start);
  EXPECT_EQ(bench.model().error_code_o, max_generation_too_large);
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
