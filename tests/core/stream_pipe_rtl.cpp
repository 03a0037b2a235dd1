// stream_pipe: around a pipeline of as many clocks, held against a queue at every clock, under any traffic and with resets; three clocks
// more than the pipeline, and a word a clock at its own depth. With fewer places nothing is lost.
// verilate: Vstream_pipe_1 Latency=1
// verilate: Vstream_pipe_6 Latency=6
// verilate: Vstream_pipe_6_shallow Latency=6 Depth=3
#include <gtest/gtest.h>

#include "Vstream_pipe_1.h"
#include "Vstream_pipe_6.h"
#include "Vstream_pipe_6_shallow.h"
#include "tests/core/fifo_bench.hpp"

namespace relievo::test {
namespace {

// The pipe with its pipeline: what goes in at in_i is at data_i Latency clocks later.
template <class Model, int Latency>
struct piped : Model {
  explicit piped(VerilatedContext* context) : Model(context) {}
  void eval() {
    if (this->clk_i && !before_) {
      for (int i = Latency - 1; i > 0; --i) inside_[i] = inside_[i - 1];
      inside_[0] = in_i;
    }
    before_ = this->clk_i != 0;
    Model::eval();
    if (this->clk_i) this->data_i = inside_[Latency - 1];
  }
  int count() const { return -1; }
  bool in_i = false;

 private:
  bool before_ = false;
  bool inside_[Latency] = {};
};

TEST(stream_pipe, one_clock_under_any_traffic) { any_traffic<piped<Vstream_pipe_1, 1>>(6, 1 + 3); }
TEST(stream_pipe, six_clocks_under_any_traffic) { any_traffic<piped<Vstream_pipe_6, 6>>(11, 6 + 3); }
TEST(stream_pipe, fewer_places_than_clocks_lose_nothing) { any_traffic<piped<Vstream_pipe_6_shallow, 6>>(3, 6 + 3); }
TEST(stream_pipe, a_word_a_clock_through_one) { full_rate<piped<Vstream_pipe_1, 1>>(6, 1 + 3); }
TEST(stream_pipe, a_word_a_clock_through_six) { full_rate<piped<Vstream_pipe_6, 6>>(11, 6 + 3); }

}  // namespace
}  // namespace relievo::test
