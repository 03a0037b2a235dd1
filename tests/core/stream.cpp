// stream: first in, first out, around the end of its storage; bounded; misuse ends the program with the stream's name, and words left
// over are reported.
#include "hls/core/stream.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "tests/support/random.hpp"

namespace relievo::test {
namespace {

TEST(stream, equals_a_queue_under_random_traffic) {
  generator g("traffic");
  hls::stream<std::uint64_t, 5> s("traffic");
  std::deque<std::uint64_t> right;
  std::uint64_t written = 0, fulls = 0;
  for (int i = 0; i < 200000; ++i) {
    ASSERT_EQ(s.size(), static_cast<int>(right.size()));
    ASSERT_EQ(s.empty(), right.empty());
    ASSERT_EQ(s.full(), right.size() == 5);
    fulls += s.full() ? 1 : 0;
    // Long runs of either, so that both ends are reached.
    const bool wants_write = (i / 50) % 3 == 0 ? true : (i / 50) % 3 == 1 ? false : g.chance(2);
    if (wants_write && !s.full()) {
      s.write(written);
      right.push_back(written++);
    } else if (!wants_write && !s.empty()) {
      ASSERT_EQ(s.read(), right.front());
      right.pop_front();
    }
  }
  EXPECT_GT(fulls, 1000u);
  EXPECT_GT(written, 10000u);
  while (!s.empty()) s.read();
}

TEST(stream, a_depth_of_one_holds_one_word) {
  hls::stream<int, 1> s("single");
  for (int i = 0; i < 3; ++i) {
    s.write(i);
    EXPECT_TRUE(s.full());
    EXPECT_EQ(s.read(), i);
    EXPECT_TRUE(s.empty());
  }
}

void write_three() {
  hls::stream<int, 2> s("edge.triangles");
  for (int i = 0; i < 3; ++i) s.write(i);
}
void read_two_of_one() {
  hls::stream<int, 2> s("edge.triangles");
  s.write(1);
  s.read();
  s.read();
}

TEST(stream_death_test, misuse_ends_the_program_with_the_streams_name) {
  EXPECT_DEATH(write_three(), "edge.triangles: write to a full stream");
  EXPECT_DEATH(read_two_of_one(), "edge.triangles: read from an empty stream");
}

TEST(stream, words_left_over_are_reported) {
  testing::internal::CaptureStderr();
  {
    hls::stream<int, 4> s("edge.out");
    for (int i = 0; i < 3; ++i) s.write(i);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "edge.out: 3 words left over\n");
  testing::internal::CaptureStderr();
  {
    hls::stream<int, 4> s("edge.out");
    s.write(1);
    s.read();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace relievo::test
