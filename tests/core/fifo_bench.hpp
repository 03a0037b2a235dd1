// fifo_bench: holds a FIFO of one-bit words against a queue, clock by clock: in_ready, out_valid, the word and the count are exactly those
// that the header promises.
//
//   fifo_bench<Unit> bench(depth, latency);
//   bench.run({idle, stall, reset}, clocks)    random words; how often, in sixteenths, none is offered and none is taken, and, in
//                                              thousandths, a reset comes
//     Unit      clk_i, rst_ni, in_valid_i, in_ready_o, in_i, out_valid_o, out_ready_i, out_o, eval(); count() or -1
//   A word taken at one clock is out latency clocks later, or one clock after the word before it if that is later; a word is taken unless
//   depth are held.
#pragma once
#include <verilated.h>

#include <deque>

#include "tb/cosim/coverage.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {

struct fifo_traffic {
  std::uint64_t idle, stall, reset;
};

template <class Unit>
class fifo_bench {
 public:
  fifo_bench(std::size_t depth, std::uint64_t latency) : depth_(depth), latency_(latency) {
    context_.randReset(2);
    context_.randSeed(reset_seed());
    unit_.rst_ni = 0;
    unit_.in_valid_i = unit_.out_ready_i = 0;
    clock();
    kept_.begin();
  }

  void run(fifo_traffic const& t, std::uint64_t clocks) {
    for (const std::uint64_t end = now_ + clocks; now_ < end && !testing::Test::HasFailure();) {
      unit_.rst_ni = g_.below(1000) >= t.reset;
      // Valid holds until its word is taken; what is not valid may be anything.
      if (!unit_.in_valid_i || taken_) {
        unit_.in_valid_i = g_.below(16) >= t.idle;
        unit_.in_i = g_.chance(2);
      }
      if (!unit_.in_valid_i) unit_.in_i = g_.chance(2);
      unit_.out_ready_i = g_.below(16) >= t.stall;
      unit_.eval();
      step();
    }
  }
  std::uint64_t words_out() const { return words_out_; }
  std::uint64_t fulls() const { return fulls_; }
  std::uint64_t empties() const { return empties_; }

 private:
  struct held {
    bool word;
    std::uint64_t due;
  };

  void step() {
    const bool valid = !held_.empty() && held_.front().due <= now_;
    ASSERT_EQ(unit_.in_ready_o, held_.size() != depth_) << "in_ready with " << held_.size() << " held, clock " << now_;
    ASSERT_EQ(unit_.out_valid_o, valid) << "out_valid with " << held_.size() << " held, clock " << now_;
    if (unit_.count() >= 0) {
      ASSERT_EQ(unit_.count(), static_cast<int>(held_.size())) << "clock " << now_;
    }
    if (valid) {
      ASSERT_EQ(unit_.out_o, held_.front().word) << "clock " << now_;
    }
    fulls_ += held_.size() == depth_ ? 1 : 0;
    empties_ += held_.empty() ? 1 : 0;

    taken_ = unit_.in_valid_i && unit_.in_ready_o;
    const bool leaves = valid && unit_.out_ready_i;
    if (leaves) held_.pop_front();
    words_out_ += leaves ? 1 : 0;
    if (taken_) held_.push_back({unit_.in_i != 0, now_ + latency_});
    // Offered at a reset, the next word is another one.
    if (!unit_.rst_ni) {
      held_.clear();
      taken_ = true;
    }
    clock();
  }
  void clock() {
    unit_.clk_i = 0;
    unit_.eval();
    unit_.clk_i = 1;
    unit_.eval();
    ++now_;
  }

  std::size_t depth_;
  std::uint64_t latency_, now_ = 0, words_out_ = 0, fulls_ = 0, empties_ = 0;
  bool taken_ = true;
  VerilatedContext context_;
  Unit unit_{&context_};
  tb::keep_coverage kept_{context_};
  generator g_ = next_generator();
  std::deque<held> held_;
};

// All mixtures of traffic one after the other, then with resets between.
template <class Unit>
void any_traffic(std::size_t depth, std::uint64_t latency) {
  fifo_bench<Unit> bench(depth, latency);
  for (const std::uint64_t reset : {0, 10})
    for (const std::uint64_t idle : {0, 1, 7, 15})
      for (const std::uint64_t stall : {0, 1, 7, 15}) bench.run({idle, stall, reset}, 1000);
  EXPECT_GT(bench.words_out(), 5000u);
  EXPECT_GT(bench.fulls(), 100u);
  EXPECT_GT(bench.empties(), 100u);
}

// A word a clock, from the first on.
template <class Unit>
void full_rate(std::size_t depth, std::uint64_t latency) {
  fifo_bench<Unit> bench(depth, latency);
  bench.run({0, 0, 0}, 1000 + latency);
  EXPECT_EQ(bench.words_out(), 1000u);
}

}  // namespace relievo::test
