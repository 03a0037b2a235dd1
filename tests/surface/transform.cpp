// transform: hls equals golden; the quotient against integers; before, at and behind the eye; far off the screen saturates.
#include "hls/surface/transform.hpp"

#include <gtest/gtest.h>

#include "golden/surface/transform.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::transform_in, hls::transform_regs>;

testing::AssertionResult hls_equals_golden(vector const& v) {
  return equal_words(hls::transform(v.in, v.regs),
                     golden::transform<golden::rounded>(as_golden<golden::transform_in>(v.in), as_golden<golden::transform_regs>(v.regs)));
}

TEST(transform, hls_equals_golden) { for_vectors<vector>(any_word(), hls_equals_golden); }

// A camera before the scene: w between 1 and 127, few saturations, so that the division itself is at work.
void before_the_eye(vector& v, generator& g) {
  for (auto& m : v.regs.row_w) m = hls::from_raw<formats::matrix_w>(raw(m) >> 3);
  for (auto& m : v.regs.row_x) m = hls::from_raw<formats::matrix_xy>(raw(m) >> 2);
  for (auto& m : v.regs.row_y) m = hls::from_raw<formats::matrix_xy>(raw(m) >> 2);
  v.regs.offset_x = hls::from_raw<formats::offset_xy>(raw(v.regs.offset_x) >> 5);
  v.regs.offset_y = hls::from_raw<formats::offset_xy>(raw(v.regs.offset_y) >> 5);
  v.regs.offset_w = hls::from_raw<formats::offset_w>(g.between(std::int64_t(8) << 44, std::int64_t(120) << 44));
  v.regs.w_min = hls::from_raw<formats::depth>(std::int64_t(1) << 12);
}

TEST(transform, hls_equals_golden_before_the_eye) {
  std::uint64_t on_screen = 0, seen = 0;
  for_vectors<vector>(before_the_eye, [&](vector const& v) {
    const auto out = hls::transform(v.in, v.regs);
    ++seen;
    on_screen += out.saturated || out.behind ? 0 : 1;
    return hls_equals_golden(v);
  });
  EXPECT_GT(on_screen, seen / 2) << "the vectors miss the division";
}

// |w - w_min| of a few LSB: the decision and both sides of it.
TEST(transform, hls_equals_golden_at_the_eye) {
  std::uint64_t behind = 0, seen = 0;
  for_vectors<vector>(
      [](vector& v, generator& g) {
        for (auto& m : v.regs.row_w) m = hls::from_raw<formats::matrix_w>(0);
        v.regs.w_min = hls::from_raw<formats::depth>(g.between(0, 4096));
        v.regs.offset_w =
            hls::from_raw<formats::offset_w>((raw(v.regs.w_min) << 24) + g.between(-(std::int64_t(3) << 24), std::int64_t(3) << 24));
      },
      [&](vector const& v) {
        const auto out = hls::transform(v.in, v.regs);
        ++seen;
        behind += out.behind ? 1 : 0;
        return hls_equals_golden(v);
      },
      vector_count() / 2);
  EXPECT_GT(behind, seen / 4);
  EXPECT_LT(behind, seen * 3 / 4);
}

// The identity camera: screen = p / w with w from the offset alone.
vector identity(std::int64_t w) {
  vector v{};
  v.regs.row_x[0] = hls::from_raw<formats::matrix_xy>(std::int64_t(1) << formats::matrix_xy::fraction);
  v.regs.row_y[1] = hls::from_raw<formats::matrix_xy>(std::int64_t(1) << formats::matrix_xy::fraction);
  v.regs.offset_w = hls::from_raw<formats::offset_w>(w * (std::int64_t(1) << (formats::offset_w::fraction - formats::depth::fraction)));
  v.regs.w_min = hls::from_raw<formats::depth>(std::int64_t(1) << 12);
  return v;
}

// round half up of 2^8 p / w, decided in integers: 2^9 p >= (2 q - 1) w and below (2 q + 1) w.
TEST(transform, every_quotient_is_correctly_rounded) {
  generator g("quotient");
  std::uint64_t checked = 0;
  for (std::uint64_t i = 0; i < vector_count() / 4; ++i) {
    const std::int64_t w = g.between(1 << 12, 1 << 24), p = g.between(-(1 << 23), (1 << 23) - 1);
    vector v = identity(w);
    v.in.p[0] = hls::from_raw<formats::position>(p);
    v.in.p[1] = hls::from_raw<formats::position>(-p - 1);
    const auto out = hls::transform(v.in, v.regs);
    if (out.saturated) continue;
    const std::int64_t q = raw(out.screen[0]), r = raw(out.screen[1]);
    ASSERT_TRUE((2 * q - 1) * w <= 512 * p && 512 * p < (2 * q + 1) * w) << p << " / " << w << " gives " << q;
    ASSERT_TRUE((2 * r - 1) * w <= 512 * (-p - 1) && 512 * (-p - 1) < (2 * r + 1) * w) << -p - 1 << " / " << w << " gives " << r;
    ASSERT_EQ(raw(out.w), w);
    ++checked;
  }
  EXPECT_GT(checked, vector_count() / 5);
}

TEST(transform, the_eye_plane_itself_is_behind_even_with_a_w_min_of_zero) {
  vector v = identity(0);
  v.regs.w_min = hls::from_raw<formats::depth>(0);
  v.in.p[0] = hls::from_raw<formats::position>(1);
  EXPECT_TRUE(hls::transform(v.in, v.regs).behind);
  EXPECT_EQ(raw(hls::transform(v.in, v.regs).screen[0]), 0);
  v = identity(1);
  v.regs.w_min = hls::from_raw<formats::depth>(0);
  EXPECT_FALSE(hls::transform(v.in, v.regs).behind);
}

TEST(transform, at_w_min_is_before_the_eye_and_one_lsb_nearer_is_behind) {
  vector v = identity(1 << 12);
  v.in.p[0] = hls::from_raw<formats::position>(1 << 12);
  auto out = hls::transform(v.in, v.regs);
  EXPECT_FALSE(out.behind);
  EXPECT_EQ(raw(out.screen[0]), 256);
  v = identity((1 << 12) - 1);
  v.in.p[0] = hls::from_raw<formats::position>(1 << 12);
  out = hls::transform(v.in, v.regs);
  EXPECT_TRUE(out.behind);
  EXPECT_EQ(raw(out.screen[0]), 0);
  EXPECT_EQ(raw(out.w), (1 << 12) - 1);
  // The comparison is of the rounded register: half an LSB below w_min rounds up to it.
  v = identity(1 << 12);
  v.regs.offset_w = hls::from_raw<formats::offset_w>(raw(v.regs.offset_w) - (1 << 23));
  EXPECT_FALSE(hls::transform(v.in, v.regs).behind);
  v.regs.offset_w = hls::from_raw<formats::offset_w>(raw(v.regs.offset_w) - 1);
  EXPECT_TRUE(hls::transform(v.in, v.regs).behind);
}

TEST(transform, behind_the_eye_w_is_zero_and_nothing_saturates) {
  vector v = identity(-5);
  for (auto& p : v.in.p) p = hls::from_raw<formats::position>(hls::fixed<formats::position>::max_raw);
  for (auto& m : v.regs.row_x) m = hls::from_raw<formats::matrix_xy>(hls::fixed<formats::matrix_xy>::max_raw);
  v.regs.offset_x = hls::from_raw<formats::offset_xy>(hls::fixed<formats::offset_xy>::max_raw);
  const auto out = hls::transform(v.in, v.regs);
  EXPECT_TRUE(out.behind);
  EXPECT_FALSE(out.saturated);
  EXPECT_EQ(raw(out.w), 0);
  EXPECT_EQ(raw(out.screen[0]), 0);
}

TEST(transform, far_off_the_screen_saturates_to_the_end_of_the_format) {
  vector v = identity(1 << 12);
  v.in.p[0] = hls::from_raw<formats::position>(-(1 << 23));
  v.regs.row_x[0] = hls::from_raw<formats::matrix_xy>(std::int64_t(1024) << formats::matrix_xy::fraction);
  const auto out = hls::transform(v.in, v.regs);
  EXPECT_TRUE(out.saturated);
  EXPECT_FALSE(out.behind);
  EXPECT_EQ(raw(out.screen[0]), hls::fixed<formats::screen>::min_raw);
  EXPECT_EQ(raw(out.screen[1]), 0);
}

TEST(transform, a_depth_beyond_its_format_saturates) {
  vector v = identity(hls::fixed<formats::depth>::max_raw);
  EXPECT_FALSE(hls::transform(v.in, v.regs).saturated);
  v.regs.row_w[0] = hls::from_raw<formats::matrix_w>(std::int64_t(1) << formats::matrix_w::fraction);
  v.in.p[0] = hls::from_raw<formats::position>(1 << 20);
  const auto out = hls::transform(v.in, v.regs);
  EXPECT_TRUE(out.saturated);
  EXPECT_EQ(raw(out.w), hls::fixed<formats::depth>::max_raw);
}

}  // namespace
}  // namespace relievo::test
