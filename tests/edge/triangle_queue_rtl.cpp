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
#include "tests/support/queue_bench.hpp"

namespace relievo::test {
namespace {

// Every combination of mode, engine and traffic at one depth and limit.
template <class Model, int Depth>
void every_traffic(int max_generation, bool smallest) {
  for (const bool fifo : {false, true})
    for (const int capacity : {1, 5, 64})
      for (const std::uint64_t idle : {0, 7})
        for (const int splits : {16, 7}) {
          const bool busy = capacity == 64;
          queue_bench<Model, Depth> b({Depth, max_generation, fifo, capacity, busy ? 20 : 1, busy ? 80 : 6, idle, splits, 1000});
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
  queue_bench<Vqueue_100_eight, 100> b({100, 5, false, 64, 30, 30, 0, 8, 3000});
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
        queue_bench<Vqueue_100_single, 100> b({100, m, fifo, 1 + round % 3, 1, 9, static_cast<std::uint64_t>(round % 2 * 5), 13, 2000});
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
    queue_bench<Vqueue_1024, 1024> b({1024, 15, fifo, 64, 60, 60, 0, 16, 0});
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
  tb::keep_coverage kept(context);
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
  for (int i = 0; i < 3; ++i) {
    edge();
    kept.begin();
  }
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
  queue_bench<Vqueue_49, 49> b({49, 9, false, 64, 1, 30, 3, 14, 1500});
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
