// stream_register: held against a queue of two at every clock, under any traffic and with resets; one clock of latency, a word a clock.
// verilate: Vstream_register
#include <gtest/gtest.h>

#include "Vstream_register.h"
#include "tests/core/fifo_bench.hpp"

namespace relievo::test {
namespace {

struct uncounted : Vstream_register {
  explicit uncounted(VerilatedContext* context) : Vstream_register(context) {}
  int count() const { return -1; }
};

TEST(stream_register, equals_a_queue_of_two) { any_traffic<uncounted>(2, 1); }
TEST(stream_register, a_word_a_clock) { full_rate<uncounted>(2, 1); }

}  // namespace
}  // namespace relievo::test
