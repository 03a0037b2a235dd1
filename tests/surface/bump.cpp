// bump: hls equals golden; the frame's own axes come back; a mirrored frame mirrors; each register rounds half up and says when it clips.
#include "hls/surface/bump.hpp"

#include <gtest/gtest.h>

#include "golden/surface/bump.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using input = hls::bump_in;

testing::AssertionResult hls_equals_golden(input const& in) {
  return equal_words(hls::bump(in), golden::bump<golden::rounded>(as_golden<golden::bump_in>(in)));
}

TEST(bump, hls_equals_golden) { for_vectors<input>(any_word(), hls_equals_golden); }

TEST(bump, hls_equals_golden_on_unit_vectors) {
  for_vectors<input>(
      [](input& in, generator& g) {
        unit_vector(in.n, g);
        unit_vector(in.t, g);
        unit_vector(in.m, g);
      },
      hls_equals_golden);
}

// Opposite contributions, so that what is normalised is small or nothing.
TEST(bump, hls_equals_golden_where_little_is_left) {
  for_vectors<input>(
      [](input& in, generator& g) {
        unit_vector(in.n, g);
        for (int i = 0; i < 3; ++i) near(in.t[i], in.n[i], 3, g);
        near(in.m[0], hls::from_raw<formats::unit>(-raw(in.m[2]) == 32768 ? 32767 : -raw(in.m[2])), 2, g);
      },
      hls_equals_golden, vector_count() / 2);
}

hls::fixed<formats::unit> unit(std::int64_t word) { return hls::from_raw<formats::unit>(word); }
input frame(std::int64_t mx, std::int64_t my, std::int64_t mz) {
  return {{unit(0), unit(0), unit(16384)}, {unit(16384), unit(0), unit(0)}, {unit(mx), unit(my), unit(mz)}};
}

TEST(bump, the_map_normal_in_the_frame_of_the_axes_is_itself) {
  for (std::int64_t m = -16384; m <= 16384; m += 64) {
    const std::int64_t other = std::lround(std::sqrt(16384.0 * 16384.0 - static_cast<double>(m * m)));
    const auto out = hls::bump(frame(m, other, 0));
    EXPECT_FALSE(out.zero || out.saturated);
    // Its length is one but for the rounding of `other`, so a component moves by one LSB at most.
    EXPECT_LE(std::abs(raw(out.n[0]) - m), 1);
    EXPECT_LE(std::abs(raw(out.n[1]) - other), 1);
    EXPECT_EQ(raw(out.n[2]), 0);
  }
}

TEST(bump, nothing_left_gives_the_axis_and_says_so) {
  const auto out = hls::bump(frame(0, 0, 0));
  EXPECT_TRUE(out.zero);
  EXPECT_EQ(raw(out.n[0]), 0);
  EXPECT_EQ(raw(out.n[1]), 0);
  EXPECT_EQ(raw(out.n[2]), 16384);
  EXPECT_FALSE(hls::bump(frame(0, 0, 1)).zero);
}

TEST(bump, a_bitangent_beyond_the_unit_format_is_flagged) {
  // n x t = (0, 0, 2 * 2 - (-2) * 2) = 8, far beyond 2.
  const input in = {{unit(32767), unit(32767), unit(0)}, {unit(-32768), unit(32767), unit(0)}, {unit(0), unit(0), unit(16384)}};
  EXPECT_TRUE(hls::bump(in).saturated);
  EXPECT_TRUE(golden::bump<golden::rounded>(as_golden<golden::bump_in>(in)).saturated);
}

}  // namespace
}  // namespace relievo::test
