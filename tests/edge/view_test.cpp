// view_test: hls equals golden; symmetric in the ends; one LSB either side of the threshold; an end behind the eye is always long.
#include "hls/edge/view_test.hpp"

#include <gtest/gtest.h>

#include "golden/edge/view_test.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::view_test_in, hls::view_test_regs>;

testing::AssertionResult agrees(vector const& v) {
  const auto out = hls::view_test(v.in, v.regs);
  const auto result = equal_words(
      out, golden::view_test<golden::rounded>(as_golden<golden::view_test_in>(v.in), as_golden<golden::view_test_regs>(v.regs)));
  if (!result) return result;
  vector back = v;
  for (int i = 0; i < 2; ++i) {
    back.in.screen1[i] = v.in.screen2[i];
    back.in.screen2[i] = v.in.screen1[i];
  }
  back.in.behind1 = v.in.behind2;
  back.in.behind2 = v.in.behind1;
  return hls::view_test(back.in, v.regs).vt == out.vt ? result : testing::AssertionFailure() << "the ends are not alike";
}

TEST(view_test, hls_equals_golden_from_either_end) { for_vectors<vector>(any_word(), agrees); }

TEST(view_test, hls_equals_golden_at_the_threshold) {
  std::uint64_t positive = 0, seen = 0;
  for_vectors<vector>(
      [](vector& v, generator& g) {
        v.in.behind1 = v.in.behind2 = false;
        std::int64_t distance = 0;
        for (int i = 0; i < 2; ++i) distance += std::abs(raw(v.in.screen1[i]) - raw(v.in.screen2[i]));
        distance += g.between(-1, 1);
        v.regs.threshold = hls::from_raw<formats::view_threshold>(distance < 0 ? 0 : distance);
      },
      [&](vector const& v) {
        ++seen;
        positive += hls::view_test(v.in, v.regs).vt ? 1 : 0;
        return agrees(v);
      });
  EXPECT_GT(positive, seen / 8);
  EXPECT_LT(positive, seen / 2) << "equal to the threshold is not above it";
}

TEST(view_test, either_end_behind_the_eye_is_long_whatever_the_threshold) {
  vector v{};
  v.regs.threshold = hls::from_raw<formats::view_threshold>(hls::fixed<formats::view_threshold>::max_raw);
  EXPECT_FALSE(hls::view_test(v.in, v.regs).vt);
  v.in.behind1 = true;
  EXPECT_TRUE(hls::view_test(v.in, v.regs).vt);
  v.in.behind1 = false;
  v.in.behind2 = true;
  EXPECT_TRUE(hls::view_test(v.in, v.regs).vt);
}

TEST(view_test, the_distance_is_the_sum_of_both_axes) {
  vector v{};
  v.in.screen1[0] = hls::from_raw<formats::screen>(-300);
  v.in.screen2[1] = hls::from_raw<formats::screen>(-400);
  v.regs.threshold = hls::from_raw<formats::view_threshold>(700);
  EXPECT_FALSE(hls::view_test(v.in, v.regs).vt);
  v.regs.threshold = hls::from_raw<formats::view_threshold>(699);
  EXPECT_TRUE(hls::view_test(v.in, v.regs).vt);
}

}  // namespace
}  // namespace relievo::test
