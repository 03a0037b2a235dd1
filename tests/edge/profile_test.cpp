// profile_test: hls equals golden on every kind of map, at its threshold too; the other end gives the mirrored answer; how many
// intervals an edge has; where ties go; what lies outside the middle third counts for pt and not for k.
#include "hls/edge/profile_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "golden/edge/profile_test.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::profile_test_in, hls::profile_test_regs>;

testing::AssertionResult agrees(vector const& v, test_map const& map, hls::map_regs const& regs) {
  const auto out = hls::profile_test(v.in, regs, v.regs, map.texels());
  const auto result =
      equal_words(out, golden::profile_test<golden::rounded>(as_golden<golden::profile_test_in>(v.in), as_golden<golden::map_regs>(regs),
                                                             as_golden<golden::profile_test_regs>(v.regs), map.golden_texels()));
  if (!result) return result;
  vector back = v;
  for (int i = 0; i < 2; ++i) {
    back.in.u1[i] = v.in.u2[i];
    back.in.u2[i] = v.in.u1[i];
  }
  back.in.forward = !v.in.forward;
  const auto other = hls::profile_test(back.in, regs, v.regs, map.texels());
  if (other.pt != out.pt || raw(other.k) != 16 - raw(out.k))
    return testing::AssertionFailure() << "from the other end pt " << other.pt << ", k " << raw(other.k) << "; from here " << raw(out.k);
  return result;
}

void edge_within(vector& v, hls::map_regs const& map, generator& g) {
  coordinates_within(v.in.u1, map, g);
  if (g.chance(2))
    for (int i = 0; i < 2; ++i) near(v.in.u2[i], v.in.u1[i], std::int64_t(1) << g.between(8, 16), g);
  coordinates_within(v.in.u2, map, g);
}

TEST(profile_test, hls_equals_golden_from_either_end) {
  std::uint64_t positive = 0, moved = 0, seen = 0;
  for_maps([&](test_map const& map, hls::map_regs const& regs) {
    for_vectors<vector>(
        [&](vector& v, generator& g) {
          edge_within(v, regs, g);
          if (!g.chance(2)) return;
          // The threshold that the largest deviation equals, give or take an LSB.
          const auto profile = golden::profile_of<golden::rounded>(as_golden<golden::profile_test_in>(v.in),
                                                                   as_golden<golden::map_regs>(regs), map.golden_texels());
          if (profile.n == 0) return;
          const auto word = static_cast<std::int64_t>(profile.measure() * 16 / profile.n) + g.between(-1, 1);
          v.regs.threshold = hls::from_raw<formats::profile_threshold>(std::clamp<std::int64_t>(word, 0, (1 << 20) - 1));
        },
        [&](vector const& v) {
          const auto out = hls::profile_test(v.in, regs, v.regs, map.texels());
          ++seen;
          positive += out.pt ? 1 : 0;
          moved += raw(out.k) != 8 ? 1 : 0;
          return agrees(v, map, regs);
        },
        vector_count() / map_case_count + 1);
  });
  EXPECT_GT(positive, seen / 10);
  EXPECT_LT(positive, seen * 9 / 10);
  // Of two or four intervals only the middle lies in the middle third.
  if (profile_intervals_max > 4)
    EXPECT_GT(moved, seen / 25);
  else
    EXPECT_EQ(moved, 0);
}

// Every length up to 20 texels, on either axis: the smallest power of two that is not below it, between 2 and the build's most, nothing
// below 1.5.
TEST(profile_test, intervals_of_every_length) {
  for (std::int64_t d = 0; d <= 20 * 2048; ++d)
    for (int axis = 0; axis < 2; ++axis) {
      hls::fixed<formats::coordinate> u1[2] = {hls::from_raw<formats::coordinate>(50000), hls::from_raw<formats::coordinate>(50000)};
      hls::fixed<formats::coordinate> u2[2] = {u1[0], u1[1]};
      u2[axis] = hls::from_raw<formats::coordinate>(50000 + (d % 2 != 0 ? d : -d));
      const int n = d < 3072 ? 0 : std::min(d <= 2 * 2048 ? 2 : d <= 4 * 2048 ? 4 : d <= 8 * 2048 ? 8 : 16, profile_intervals_max);
      const int levels = hls::detail::profile_levels(u1, u2);
      ASSERT_EQ(levels == 0 ? 0 : 1 << levels, n) << d;
      const hls::profile_test_in in = {{u1[0], u1[1]}, {u2[0], u2[1]}, true};
      ASSERT_EQ(golden::profile_intervals(as_golden<golden::profile_test_in>(in)), n) << d;
    }
}

// A row of texels, and an edge along it from one texel to another.
struct row {
  std::vector<std::uint16_t> texels;
  std::int64_t from, to;  // in coordinate LSB

  hls::profile_test_out test(std::int64_t threshold, bool forward) const {
    hls::map_regs regs{};
    regs.width = hls::from_raw<formats::map_size>(static_cast<std::int64_t>(texels.size()));
    regs.height = hls::from_raw<formats::map_size>(1);
    hls::profile_test_in in{};
    in.u1[0] = hls::from_raw<formats::coordinate>(from);
    in.u2[0] = hls::from_raw<formats::coordinate>(to);
    in.forward = forward;
    return hls::profile_test(in, regs, {hls::from_raw<formats::profile_threshold>(threshold)}, {texels.data()});
  }
};

TEST(profile_test, below_one_and_a_half_texels_there_is_no_profile) {
  const row peak = {{0, 1000, 0}, 512, 512 + 3071};
  EXPECT_FALSE(peak.test(0, true).pt);
  EXPECT_EQ(raw(peak.test(0, true).k), 8);
  const row longer = {{0, 1000, 0}, 512, 512 + 3072};
  EXPECT_TRUE(longer.test(0, true).pt);
  EXPECT_EQ(raw(longer.test(0, true).k), 8);
}

TEST(profile_test, equal_to_the_threshold_is_not_above_it) {
  // Over two texels, the middle is 100 above the chord.
  const row peak = {{10, 120, 30}, 0, 2 * 2048};
  EXPECT_FALSE(peak.test(100 * 16, true).pt);
  EXPECT_TRUE(peak.test(100 * 16 - 1, true).pt);
  const row valley = {{120, 10, 100}, 0, 2 * 2048};
  EXPECT_FALSE(valley.test(100 * 16, true).pt);
  EXPECT_TRUE(valley.test(100 * 16 - 1, true).pt);
}

TEST(profile_test, a_flat_profile_splits_in_the_middle) {
  for (const std::int64_t length : {2, 4, 8, 16, 17}) {
    const row flat = {std::vector<std::uint16_t>(18, 777), 0, length * 2048};
    for (const bool forward : {false, true}) {
      EXPECT_FALSE(flat.test(0, forward).pt);
      EXPECT_EQ(raw(flat.test(0, forward).k), 8) << length;
    }
  }
}

TEST(profile_test, ties_go_to_the_middle_then_to_the_end_that_comes_first) {
  if (profile_intervals_max < 8) GTEST_SKIP() << "laid out for 8 intervals";
  // n = 8: equal peaks at 3 and 5; their worth e j (n - j) is the same.
  row two = {{0, 0, 0, 500, 0, 500, 0, 0, 0}, 0, 8 * 2048};
  EXPECT_EQ(raw(two.test(0, true).k), 6);
  EXPECT_EQ(raw(two.test(0, false).k), 10);
  // A middle of equal worth: 15 e_3 = 16 e_4 holds for 480 and 450.
  two.texels = {0, 0, 0, 480, 450, 480, 0, 0, 0};
  EXPECT_EQ(raw(two.test(0, true).k), 8);
  EXPECT_EQ(raw(two.test(0, false).k), 8);
  two.texels = {0, 0, 0, 481, 450, 480, 0, 0, 0};
  EXPECT_EQ(raw(two.test(0, false).k), 6);
  two.texels = {0, 0, 0, 480, 450, 481, 0, 0, 0};
  EXPECT_EQ(raw(two.test(0, true).k), 10);
}

TEST(profile_test, a_peak_outside_the_middle_third_asks_for_a_split_but_not_there) {
  if (profile_intervals_max < 16) GTEST_SKIP() << "laid out for 16 intervals";
  // n = 16: places 6 to 10 are in the middle third, 5 and 11 are not.
  for (int peak = 1; peak < 16; ++peak) {
    row r = {std::vector<std::uint16_t>(17, 100), 0, 16 * 2048};
    r.texels[static_cast<std::size_t>(peak)] = 1100;
    const auto out = r.test(1000 * 16 - 1, true);
    EXPECT_TRUE(out.pt);
    EXPECT_EQ(raw(out.k), peak >= 6 && peak <= 10 ? peak : 8) << peak;
  }
}

TEST(profile_test, the_deviation_is_from_the_chord) {
  if (profile_intervals_max < 16) GTEST_SKIP() << "laid out for 16 intervals";
  // A ramp has none, whatever its slope.
  row ramp = {{}, 0, 16 * 2048};
  for (int i = 0; i <= 16; ++i) ramp.texels.push_back(static_cast<std::uint16_t>(100 + 37 * i));
  EXPECT_FALSE(ramp.test(0, true).pt);
  // One sample of it raised by 16/16.
  ramp.texels[7] = static_cast<std::uint16_t>(ramp.texels[7] + 1);
  EXPECT_TRUE(ramp.test(15, true).pt);
  EXPECT_FALSE(ramp.test(16, true).pt);
  EXPECT_EQ(raw(ramp.test(0, true).k), 7);
}

}  // namespace
}  // namespace relievo::test
