// triangle_queue: hls equals golden under random traffic in both modes; newest first, oldest first while it fits, and never more than
// 3 M + 4 entries for the worst descents there are.
#include "hls/edge/triangle_queue.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "golden/edge/triangle_queue.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

hls::fixed<formats::generation> generation(std::int64_t g) { return hls::from_raw<formats::generation>(g); }
hls::triangle numbered(std::int64_t n) {
  hls::triangle t{};
  t.index = hls::from_raw<formats::index>(n);
  return t;
}

template <int Depth>
void expect_equal_traffic(int max_generation) {
  generator g("traffic" + std::to_string(Depth) + " " + std::to_string(max_generation));
  const auto queue = std::make_unique<hls::triangle_queue<Depth>>();
  for (const bool fifo : {false, true}) {
    queue->start();
    golden::triangle_queue right(Depth, {fifo}, max_generation);
    std::uint64_t fallbacks = 0;
    std::int64_t number = 0;
    std::size_t held = 0;
    for (int i = 0; i < 20000; ++i) {
      // Long rises and falls, up to full and down to empty.
      const bool wants_push = (i / (2 * Depth)) % 2 == 0 ? !g.chance(4) : g.chance(4);
      if (wants_push && held < Depth) {
        hls::triangle t = numbered(number++);
        queue->push(t);
        right.push(as_golden<golden::triangle>(t));
        ++held;
      } else if (held > 0) {
        bool fallback = false;
        const hls::triangle t = queue->pop({fifo}, generation(max_generation), fallback);
        fallbacks += fallback ? 1 : 0;
        ASSERT_TRUE(equal_words(t, right.pop())) << "fifo " << fifo << ", step " << i;
        --held;
      }
      ASSERT_EQ(queue->empty(), right.empty());
      ASSERT_EQ(static_cast<std::uint64_t>(queue->high_water()), right.high_water());
      ASSERT_EQ(fallbacks, right.fallbacks());
    }
    EXPECT_EQ(queue->high_water(), Depth) << "the traffic never filled it";
    if (fifo && 3 * max_generation + 4 <= Depth) {
      EXPECT_GT(fallbacks, 0u);
    }
  }
}

TEST(triangle_queue, hls_equals_golden_under_random_traffic) {
  expect_equal_traffic<4>(0);
  expect_equal_traffic<7>(1);
  expect_equal_traffic<16>(2);
  expect_equal_traffic<49>(15);
  expect_equal_traffic<100>(15);
}

TEST(triangle_queue, lifo_takes_the_newest_and_fifo_the_oldest) {
  const auto queue = std::make_unique<hls::triangle_queue<16>>();
  for (const bool fifo : {false, true}) {
    queue->start();
    for (std::int64_t i = 0; i < 5; ++i) queue->push(numbered(i));
    bool fallback = true;
    EXPECT_EQ(raw(queue->pop({fifo}, generation(0), fallback).index), fifo ? 0 : 4);
    EXPECT_FALSE(fallback);
    EXPECT_EQ(raw(queue->pop({fifo}, generation(0), fallback).index), fifo ? 1 : 3);
  }
}

// M = 2 asks for 10 free entries once the popped one is out: with 16 in all, up to 7 waiting the oldest goes, with 8 the newest.
TEST(triangle_queue, fifo_falls_back_exactly_where_a_whole_descent_no_longer_fits) {
  const auto queue = std::make_unique<hls::triangle_queue<16>>();
  for (int waiting = 1; waiting <= 16; ++waiting) {
    queue->start();
    for (std::int64_t i = 0; i < waiting; ++i) queue->push(numbered(i));
    bool fallback = false;
    const auto t = queue->pop({true}, generation(2), fallback);
    EXPECT_EQ(fallback, waiting > 7) << waiting;
    EXPECT_EQ(raw(t.index), waiting > 7 ? waiting - 1 : 0) << waiting;
  }
}

TEST(triangle_queue, start_forgets_what_was_waiting) {
  const auto queue = std::make_unique<hls::triangle_queue<8>>();
  for (std::int64_t i = 0; i < 6; ++i) queue->push(numbered(i));
  queue->start();
  EXPECT_TRUE(queue->empty());
  EXPECT_EQ(queue->high_water(), 0);
  queue->push(numbered(9));
  bool fallback = false;
  EXPECT_EQ(raw(queue->pop({false}, generation(0), fallback).index), 9);
}

TEST(triangle_queue_death_test, a_push_beyond_its_depth_ends_the_program) {
  hls::triangle_queue<4> queue;
  const auto push_five = [&queue] {
    for (std::int64_t i = 0; i < 5; ++i) queue.push(numbered(i));
  };
  EXPECT_DEATH(push_five(), "triangle_queue: push on a full queue of 4 entries");
}

// A triangle of generation g < M may return four of generation g + 1. Every triangle that can, does, until `budget` are through; then
// only those that a random number picks. Depth is 3 M + 4.
template <int M>
void expect_room(bool fifo) {
  constexpr int depth = 3 * M + 4;
  const auto queue = std::make_unique<hls::triangle_queue<depth>>();
  generator g("room" + std::to_string(M));
  queue->start();
  int held = 0, highest = 0;
  std::int64_t budget = 3000;
  for (int base = 0; base < 200; ++base) {
    int depth_of = 0;
    for (bool first = true; first || held > 0; first = false) {
      if (!first) {
        bool fallback = false;
        depth_of = static_cast<int>(raw(queue->pop({fifo}, generation(M), fallback).generation[0]));
        --held;
      } else {
        depth_of = 0;
      }
      const bool splits = depth_of < M && (budget > 0 || g.chance(5));
      --budget;
      const int parts = !splits ? 0 : budget > 0 ? 4 : static_cast<int>(g.between(2, 4));
      for (int i = 0; i < parts; ++i) {
        hls::triangle t{};
        t.generation[0] = generation(depth_of + 1);
        queue->push(t);
        ++held;
      }
      highest = std::max(highest, held);
      ASSERT_LE(held, depth) << "M = " << M << ", fifo " << fifo;
    }
  }
  EXPECT_EQ(queue->high_water(), highest);
  // Depth first, a descent leaves three behind at each of M generations and the last brings four.
  if (!fifo) {
    EXPECT_EQ(highest, M == 0 ? 0 : 3 * M + 1);
  }
}

TEST(triangle_queue, three_m_plus_four_entries_are_enough) {
  for (const bool fifo : {false, true}) {
    expect_room<0>(fifo);
    expect_room<1>(fifo);
    expect_room<2>(fifo);
    expect_room<6>(fifo);
    expect_room<15>(fifo);
  }
}

}  // namespace
}  // namespace relievo::test
