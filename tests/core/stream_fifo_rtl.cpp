// stream_fifo: held against a queue at every clock, under any traffic and with resets; three clocks of latency, and a word a clock from
// four places on.
// verilate: Vstream_fifo_2 Depth=2
// verilate: Vstream_fifo_4 Depth=4
// verilate: Vstream_fifo_21 Depth=21
#include <gtest/gtest.h>

#include "Vstream_fifo_2.h"
#include "Vstream_fifo_21.h"
#include "Vstream_fifo_4.h"
#include "tests/core/fifo_bench.hpp"

namespace relievo::test {
namespace {

template <class Model>
struct counted : Model {
  explicit counted(VerilatedContext* context) : Model(context) {}
  int count() const { return this->count_o; }
};

constexpr std::uint64_t latency = 3;

TEST(stream_fifo, equals_a_queue_of_two) { any_traffic<counted<Vstream_fifo_2>>(2, latency); }
TEST(stream_fifo, equals_a_queue_of_four) { any_traffic<counted<Vstream_fifo_4>>(4, latency); }
TEST(stream_fifo, equals_a_queue_of_21) { any_traffic<counted<Vstream_fifo_21>>(21, latency); }
TEST(stream_fifo, a_word_a_clock_through_four_places) { full_rate<counted<Vstream_fifo_4>>(4, latency); }

}  // namespace
}  // namespace relievo::test
