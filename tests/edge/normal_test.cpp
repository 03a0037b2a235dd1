// normal_test: hls equals golden; symmetric in the ends; one LSB either side of the threshold in every component.
#include "hls/edge/normal_test.hpp"

#include <gtest/gtest.h>

#include "golden/edge/normal_test.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::normal_test_in, hls::normal_test_regs>;

testing::AssertionResult agrees(vector const& v) {
  const auto out = hls::normal_test(v.in, v.regs);
  const auto result = equal_words(
      out, golden::normal_test<golden::rounded>(as_golden<golden::normal_test_in>(v.in), as_golden<golden::normal_test_regs>(v.regs)));
  if (!result) return result;
  vector back = v;
  for (int i = 0; i < 3; ++i) {
    back.in.n1[i] = v.in.n2[i];
    back.in.n2[i] = v.in.n1[i];
  }
  return hls::normal_test(back.in, v.regs).nt == out.nt ? result : testing::AssertionFailure() << "the ends are not alike";
}

TEST(normal_test, hls_equals_golden_from_either_end) { for_vectors<vector>(any_word(), agrees); }

// All six differences within one LSB of the threshold.
TEST(normal_test, hls_equals_golden_at_the_threshold) {
  std::uint64_t positive = 0, seen = 0;
  for_vectors<vector>(
      [](vector& v, generator& g) {
        v.regs.threshold = hls::from_raw<formats::normal_threshold>(raw(v.regs.threshold) % 20000);
        for (int i = 0; i < 3; ++i) {
          const std::int64_t low = -32768 + raw(v.regs.threshold) + 1, high = 32767 - raw(v.regs.threshold) - 1;
          v.in.n12[i] = hls::from_raw<formats::unit>(g.between(low, high));
          const std::int64_t slack = g.chance(8) ? 1 : 0;
          v.in.n1[i] =
              hls::from_raw<formats::unit>(raw(v.in.n12[i]) + (g.chance(2) ? 1 : -1) * (raw(v.regs.threshold) + slack * g.between(-1, 1)));
          v.in.n2[i] = hls::from_raw<formats::unit>(raw(v.in.n12[i]) + (g.chance(2) ? 1 : -1) * (raw(v.regs.threshold)));
        }
      },
      [&](vector const& v) {
        ++seen;
        positive += hls::normal_test(v.in, v.regs).nt ? 1 : 0;
        return agrees(v);
      });
  EXPECT_GT(positive, seen / 20);
  EXPECT_LT(positive, seen / 2) << "equal to the threshold is not above it";
}

TEST(normal_test, each_difference_alone_decides) {
  for (int end = 0; end < 2; ++end)
    for (int i = 0; i < 3; ++i)
      for (const std::int64_t sign : {-1, 1}) {
        vector v{};
        v.regs.threshold = hls::from_raw<formats::normal_threshold>(100);
        (end == 0 ? v.in.n1 : v.in.n2)[i] = hls::from_raw<formats::unit>(100 * sign);
        EXPECT_FALSE(hls::normal_test(v.in, v.regs).nt);
        (end == 0 ? v.in.n1 : v.in.n2)[i] = hls::from_raw<formats::unit>(101 * sign);
        EXPECT_TRUE(hls::normal_test(v.in, v.regs).nt) << "end " << end << ", component " << i << ", sign " << sign;
      }
}

TEST(normal_test, opposite_ends_of_the_format_differ_by_more_than_any_threshold_below) {
  vector v{};
  v.in.n1[1] = hls::from_raw<formats::unit>(-32768);
  v.in.n12[1] = v.in.n2[1] = hls::from_raw<formats::unit>(32767);
  v.regs.threshold = hls::from_raw<formats::normal_threshold>(65534);
  EXPECT_TRUE(hls::normal_test(v.in, v.regs).nt);
  v.regs.threshold = hls::from_raw<formats::normal_threshold>(65535);
  EXPECT_FALSE(hls::normal_test(v.in, v.regs).nt);
}

}  // namespace
}  // namespace relievo::test
