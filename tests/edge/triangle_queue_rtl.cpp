// triangle_queue: with a model of an engine around it, every triangle comes out exactly once, no push is refused and nothing hangs, at
// the smallest depth for every generation limit and at larger ones, in both modes; one triangle in flight at a time it does exactly what
// the kernel does; one pop and one push a clock.
// verilate: Vqueue_4 Depth=4
// verilate: Vqueue_7 Depth=7
// verilate: Vqueue_10 Depth=10
// verilate: Vqueue_13 Depth=13
// verilate: Vqueue_16 Depth=16
// verilate: Vqueue_19 Depth=19
// verilate: Vqueue_22 Depth=22
// verilate: Vqueue_25 Depth=25
// verilate: Vqueue_28 Depth=28
// verilate: Vqueue_31 Depth=31
// verilate: Vqueue_34 Depth=34
// verilate: Vqueue_37 Depth=37
// verilate: Vqueue_40 Depth=40
// verilate: Vqueue_43 Depth=43
// verilate: Vqueue_46 Depth=46
// verilate: Vqueue_49 Depth=49
// verilate: Vqueue_100_single Depth=100 InFlight=1
// verilate: Vqueue_100_eight Depth=100 InFlight=8
// verilate: Vqueue_292 Depth=292
// verilate: Vqueue_1024 Depth=1024
#include <memory>
#include <set>

#include "Vqueue_10.h"
#include "Vqueue_100_eight.h"
#include "Vqueue_100_single.h"
#include "Vqueue_1024.h"
#include "Vqueue_13.h"
#include "Vqueue_16.h"
#include "Vqueue_19.h"
#include "Vqueue_22.h"
#include "Vqueue_25.h"
#include "Vqueue_28.h"
#include "Vqueue_292.h"
#include "Vqueue_31.h"
#include "Vqueue_34.h"
#include "Vqueue_37.h"
#include "Vqueue_4.h"
#include "Vqueue_40.h"
#include "Vqueue_43.h"
#include "Vqueue_46.h"
#include "Vqueue_49.h"
#include "Vqueue_7.h"
#include "hls/edge/triangle_queue.hpp"
#include "tests/support/pipeline.hpp"

namespace relievo::test {
namespace {

struct settings {
  int depth, max_generation;
  bool fifo;
  int capacity;                   // triangles that the engine holds at once, without those read ahead
  int latency_low, latency_high;  // clocks from a triangle's pop to its first child, or to its end
  std::uint64_t idle;             // sixteenths: how often the engine does not pop, not push, not retire, does not take a base triangle
  int splits;                     // sixteenths of the triangles that may split and do
  int triangles;                  // that many born, none splits any more and no base triangle comes
};

// Drives one queue, clock by clock, and is the engine around it. Triangles are numbers; what is below them is drawn when they are met.
template <class Model, int Depth>
class bench {
 public:
  explicit bench(settings const& s) : s_(s), g_(next_generator()) {
    context_.randReset(2);
    context_.randSeed(static_cast<int>(seed() & 0x7fffffff) + 1);
    model_ = std::make_unique<Model>(&context_);
    model_->regs_i = s.fifo ? 1 : 0;
    model_->max_generation_i = static_cast<unsigned char>(s.max_generation);
    reset();
  }

  void reset() {
    model_->rst_ni = 0;
    model_->push_valid_i = model_->pop_ready_i = model_->retire_i = model_->take_i = 0;
    for (int i = 0; i < 3; ++i) edge();
    model_->rst_ni = 1;
    held_.clear();
    flights_.clear();
    sequential_->start();
    fallbacks_ = 0;
    pushed_ = popped_ = taken_ = retired_ = 0;
    highest_ = 0;
    shown_ = -1;
  }

  // A chain: every triangle returns one child, for ever.
  void chain() { chain_ = true; }

  // One clock. False when something was wrong.
  bool clock() {
    Model& m = *model_;
    const int count = m.count_o, in_flight = m.in_flight_o;
    std::uint64_t const now = clocks_;

    // The engine: what it does in this clock depends on registers alone.
    m.pop_ready_i = engine_holds() < s_.capacity && works();
    m.push_valid_i = m.retire_i = m.take_i = 0;
    std::size_t pusher = flights_.size(), done = flights_.size();
    if (works()) pusher = pick([&](flight const& f) { return f.due <= now && f.children > 0; });
    if (pusher < flights_.size()) {
      flight& f = flights_[pusher];
      const std::int64_t child = static_cast<std::int64_t>(level_.size());
      level_.push_back(f.level + 1);
      m.push_valid_i = 1;
      m.push_i = static_cast<std::uint32_t>(child);
      --f.children;
    }
    if (works()) done = pick([&](flight const& f) { return f.due <= now && f.children == 0; });
    if (done < flights_.size()) {
      m.retire_i = 1;
      flights_.erase(flights_.begin() + static_cast<std::ptrdiff_t>(done));
    }
    m.eval();
    const bool take = m.may_take_o && !m.pop_valid_o && engine_holds() < s_.capacity && !wants_no_more() && works();
    m.take_i = take;
    m.eval();

    if (count > Depth) return fails("more than it holds");
    if (m.idle_o && (count != 0 || in_flight != 0)) return fails("idle with something inside");
    if (shown_ >= 0 && (!m.pop_valid_o || m.pop_o != shown_)) return fails("a popped triangle changed while it was not taken");
    const bool popped = m.pop_valid_o && m.pop_ready_i;
    shown_ = m.pop_valid_o && !popped ? static_cast<std::int64_t>(m.pop_o) : -1;
    if (popped && !leaves(m.pop_o)) return false;
    if (take) {
      fly(static_cast<std::int64_t>(level_.size()), 0);
      level_.push_back(0);
      ++taken_;
    }
    if (m.push_valid_i) {
      held_.insert(m.push_i);
      if (one_at_a_time_) {
        hls::triangle t{};
        t.index = hls::from_raw<formats::index>(m.push_i);
        sequential_->push(t);
      }
      ++pushed_;
    }
    retired_ += m.retire_i;
    const bool pushes = m.push_valid_i;
    moved_ = popped || take || pushes || m.retire_i;
    popped_now_ = popped;
    pushed_now_ = pushes;
    edge();

    if (m.error_o) return fails("a push was refused");
    // What the queue did in that clock, against its own rule with the numbers of its beginning.
    const int begun = count + (pushes ? 1 : 0) - static_cast<int>(m.count_o), free = Depth - count, limit = 3 * s_.max_generation;
    if (begun < 0 || begun > 1) return fails("the count is wrong");
    const int with_base = in_flight + (take ? 1 : 0);
    if (begun == 1 && with_base != 0 && free + 1 - 4 * (with_base + 1) < limit) return fails("a pop without credit");
    if (take && free - 4 * (in_flight + 1) < limit) return fails("a base triangle without credit");
    if (begun == 1 && count == 0) return fails("a pop from nothing");
    if (m.count_o + m.in_flight_o != pushed_ + taken_ - retired_) return fails("count and in_flight do not add up");
    const std::int64_t ahead = static_cast<std::int64_t>(m.in_flight_o) - static_cast<std::int64_t>(flights_.size());
    if (ahead < 0 || ahead > 3) return fails("not 0 to 3 read ahead");
    highest_ = std::max(highest_, static_cast<int>(m.count_o));
    return true;
  }

  // Until nothing is left; the mesh ends when enough triangles have been born.
  bool run() {
    for (std::uint64_t quiet = 0; !(wants_no_more() && model_->idle_o && flights_.empty());) {
      if (!clock()) return false;
      quiet = moved_ ? 0 : quiet + 1;
      if (quiet > 1000 + static_cast<std::uint64_t>(s_.latency_high)) return fails("nothing moves");
    }
    for (int i = 0; i < 10; ++i)
      if (!clock()) return false;
    if (!held_.empty() || popped_ != pushed_ || retired_ != popped_ + taken_) return fails("not every triangle came out once");
    if (model_->high_water_o != highest_) return fails("high water");
    return true;
  }

  // From here on the kernel's queue is driven beside; true only where never more than one triangle is in flight.
  void compare_with_kernel() { one_at_a_time_ = true; }

  Model& model() { return *model_; }
  bool popped_now() const { return popped_now_; }
  bool pushed_now() const { return pushed_now_; }
  int highest() const { return highest_; }
  std::uint64_t fallbacks() const { return model_->fallbacks_o; }
  std::uint64_t clocks() const { return clocks_; }
  std::size_t most_in_flight() const { return most_; }

 private:
  struct flight {
    std::int64_t number;
    int level, children;
    std::uint64_t due;
  };

  bool works() { return g_.below(16) >= s_.idle; }
  bool wants_no_more() const { return !chain_ && static_cast<int>(level_.size()) >= s_.triangles; }
  int engine_holds() const { return static_cast<int>(flights_.size()); }
  void fly(std::int64_t number, int level) {
    int children = 0;
    if (chain_) {
      children = level == 0 ? 4 : 1;
    } else if (level < s_.max_generation && !wants_no_more() && static_cast<int>(g_.below(16)) < s_.splits) {
      children = static_cast<int>(level_.size()) < s_.triangles / 2 ? 4 : static_cast<int>(g_.between(2, 4));
    }
    flights_.push_back({number, level, children, clocks_ + static_cast<std::uint64_t>(g_.between(s_.latency_low, s_.latency_high))});
    most_ = std::max(most_, flights_.size());
  }
  // Any of those that can, the first one every other time.
  template <class Can>
  std::size_t pick(Can can) {
    const std::size_t from = flights_.empty() || chain_ || g_.chance(2) ? 0 : g_.below(flights_.size());
    for (std::size_t i = from; i < flights_.size(); ++i)
      if (can(flights_[i])) return i;
    for (std::size_t i = 0; i < from; ++i)
      if (can(flights_[i])) return i;
    return flights_.size();
  }
  bool leaves(std::int64_t number) {
    if (held_.erase(number) == 0) return fails("a triangle came out that is not inside");
    ++popped_;
    if (one_at_a_time_) {
      bool fallback = false;
      const hls::triangle t = sequential_->pop({s_.fifo}, hls::from_raw<formats::generation>(s_.max_generation), fallback);
      fallbacks_ += fallback ? 1 : 0;
      if (raw(t.index) != number) return fails("not the triangle that the kernel pops");
      if (model_->fallbacks_o != fallbacks_) return fails("not the fallbacks of the kernel");
    }
    fly(number, level_[static_cast<std::size_t>(number)]);
    return true;
  }
  bool fails(char const* what) {
    ADD_FAILURE() << what << ", clock " << clocks_ << ", count " << static_cast<int>(model_->count_o) << ", in flight "
                  << static_cast<int>(model_->in_flight_o) << "; depth " << Depth << ", max_generation " << s_.max_generation << ", fifo "
                  << s_.fifo << ", capacity " << s_.capacity << ", seed " << seed();
    return false;
  }
  void edge() {
    model_->clk_i = 1;
    model_->eval();
    model_->clk_i = 0;
    model_->eval();
    ++clocks_;
  }

  settings s_;
  generator g_;
  VerilatedContext context_;
  std::unique_ptr<Model> model_;
  const tb::keep_coverage kept_{context_};
  std::unique_ptr<hls::triangle_queue<Depth>> sequential_ = std::make_unique<hls::triangle_queue<Depth>>();
  std::vector<int> level_;       // of every triangle ever born
  std::set<std::int64_t> held_;  // pushed and not yet out
  std::vector<flight> flights_;  // in the engine
  std::uint64_t clocks_ = 0, fallbacks_ = 0, pushed_ = 0, popped_ = 0, taken_ = 0, retired_ = 0;
  std::size_t most_ = 0;
  std::int64_t shown_ = -1;
  int highest_ = 0;
  bool chain_ = false, moved_ = false, popped_now_ = false, pushed_now_ = false, one_at_a_time_ = false;
};

// Every combination of mode, engine and traffic at one depth and limit.
template <class Model, int Depth>
void every_traffic(int max_generation, bool smallest) {
  for (const bool fifo : {false, true})
    for (const int capacity : {1, 5, 64})
      for (const std::uint64_t idle : {0, 7})
        for (const int splits : {16, 7}) {
          const bool busy = capacity == 64;
          bench<Model, Depth> b({Depth, max_generation, fifo, capacity, busy ? 20 : 1, busy ? 80 : 6, idle, splits, 1000});
          // At the smallest depth the rule lets no second triangle go: what comes out is what the kernel pops.
          if (smallest) b.compare_with_kernel();
          if (!b.run()) return;
          if (smallest) {
            ASSERT_EQ(b.most_in_flight(), 1u);
            if (splits == 16) {
              ASSERT_EQ(b.highest(), max_generation == 0 ? 0 : 3 * max_generation + 1);
            }
          }
        }
}

template <class Model, int M>
void smallest_depth() {
  every_traffic<Model, 3 * M + 4>(M, true);
}

TEST(triangle_queue, three_m_plus_four_entries_are_enough) {
  smallest_depth<Vqueue_4, 0>();
  smallest_depth<Vqueue_7, 1>();
  smallest_depth<Vqueue_10, 2>();
  smallest_depth<Vqueue_13, 3>();
  smallest_depth<Vqueue_16, 4>();
  smallest_depth<Vqueue_19, 5>();
  smallest_depth<Vqueue_22, 6>();
  smallest_depth<Vqueue_25, 7>();
  smallest_depth<Vqueue_28, 8>();
  smallest_depth<Vqueue_31, 9>();
  smallest_depth<Vqueue_34, 10>();
  smallest_depth<Vqueue_37, 11>();
  smallest_depth<Vqueue_40, 12>();
  smallest_depth<Vqueue_43, 13>();
  smallest_depth<Vqueue_46, 14>();
  smallest_depth<Vqueue_49, 15>();
}

// A few entries more, and many: the rule lets several go, and takes them one at a time again where it gets narrow.
TEST(triangle_queue, every_triangle_comes_out_once_at_larger_depths) {
  for (const int m : {0, 1, 9, 13, 14}) every_traffic<Vqueue_49, 49>(m, false);
  for (const int m : {0, 1, 2}) every_traffic<Vqueue_16, 16>(m, false);
  for (const int m : {6, 15}) every_traffic<Vqueue_292, 292>(m, false);
  every_traffic<Vqueue_100_eight, 100>(15, false);
  every_traffic<Vqueue_1024, 1024>(15, false);
}

TEST(triangle_queue, as_many_in_flight_as_it_is_told_and_no_more) {
  bench<Vqueue_100_eight, 100> b({100, 5, false, 64, 30, 30, 0, 8, 3000});
  std::size_t most = 0;
  for (int i = 0; i < 5000; ++i) {
    ASSERT_TRUE(b.clock());
    most = std::max<std::size_t>(most, b.model().in_flight_o);
  }
  EXPECT_LE(most, 8u);
  EXPECT_GE(most, 5u);
  ASSERT_TRUE(b.run());
}

// With InFlight = 1 the queue is the kernel's at any depth: the same triangles, the same fallbacks.
TEST(triangle_queue, one_at_a_time_it_pops_what_the_kernel_pops) {
  for (const bool fifo : {false, true})
    for (const int m : {3, 15, 8}) {
      std::uint64_t fallbacks = 0;
      int highest = 0;
      for (int round = 0; round < 10; ++round) {
        bench<Vqueue_100_single, 100> b({100, m, fifo, 1 + round % 3, 1, 9, static_cast<std::uint64_t>(round % 2 * 5), 13, 2000});
        b.compare_with_kernel();
        ASSERT_TRUE(b.run());
        ASSERT_EQ(b.most_in_flight(), 1u);
        fallbacks += b.fallbacks();
        highest = std::max(highest, b.highest());
      }
      if (fifo && m == 15) {
        EXPECT_GT(fallbacks, 100u) << "never full enough to fall back, " << highest << " at most";
      }
      if (!fifo) {
        EXPECT_EQ(fallbacks, 0u);
      }
    }
}

// 64 in flight, each returning one child in the clock in which it is retired: a pop and a push every clock, from either end.
TEST(triangle_queue, one_pop_and_one_push_a_clock) {
  for (const bool fifo : {false, true}) {
    bench<Vqueue_1024, 1024> b({1024, 15, fifo, 64, 60, 60, 0, 16, 0});
    b.chain();
    for (int i = 0; i < 4000; ++i) ASSERT_TRUE(b.clock());
    ASSERT_GT(b.model().count_o, 3u) << "there is nothing to pop";
    for (int i = 0; i < 4000; ++i) {
      ASSERT_TRUE(b.clock());
      ASSERT_TRUE(b.popped_now()) << "no pop in clock " << i << ", fifo " << fifo;
      ASSERT_TRUE(b.pushed_now()) << "no push in clock " << i << ", fifo " << fifo;
    }
    EXPECT_EQ(b.fallbacks(), 0u);
  }
}

TEST(triangle_queue, a_push_into_an_empty_queue_is_out_three_clocks_later) {
  VerilatedContext context;
  Vqueue_1024 m(&context);
  const tb::keep_coverage kept(context);
  const auto edge = [&m] {
    m.clk_i = 1;
    m.eval();
    m.clk_i = 0;
    m.eval();
  };
  m.max_generation_i = 15;
  m.push_valid_i = m.take_i = m.retire_i = 0;
  m.pop_ready_i = 1;
  m.rst_ni = 0;
  for (int i = 0; i < 3; ++i) edge();
  m.rst_ni = 1;
  for (int i = 0; !m.may_take_o; ++i) {
    ASSERT_LT(i, 4);
    edge();
  }
  m.take_i = 1;
  edge();
  m.take_i = 0;
  m.push_valid_i = 1;
  m.push_i = 77;
  edge();
  m.push_valid_i = 0;
  for (int i = 1; i <= 2; ++i) {
    ASSERT_FALSE(m.pop_valid_o) << i;
    edge();
  }
  ASSERT_TRUE(m.pop_valid_o);
  EXPECT_EQ(m.pop_o, 77u);
}

TEST(triangle_queue, a_reset_in_the_middle_of_a_mesh_leaves_nothing) {
  bench<Vqueue_49, 49> b({49, 9, false, 64, 1, 30, 3, 14, 1500});
  for (int i = 0; i < 700 || !b.model().pop_valid_o; ++i) ASSERT_TRUE(b.clock());
  ASSERT_GT(b.model().count_o, 0u);
  b.reset();
  EXPECT_EQ(b.model().count_o, 0u);
  EXPECT_EQ(b.model().in_flight_o, 0u);
  EXPECT_FALSE(b.model().pop_valid_o);
  EXPECT_TRUE(b.model().idle_o);
  ASSERT_TRUE(b.run());
}

}  // namespace
}  // namespace relievo::test
