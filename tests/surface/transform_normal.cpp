// transform_normal: hls equals golden; `away` is exact down to one LSB, and a normal at a right angle does not point away.
#include "hls/surface/transform_normal.hpp"

#include <gtest/gtest.h>

#include "golden/surface/transform_normal.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::transform_normal_in, hls::transform_normal_regs>;

testing::AssertionResult hls_equals_golden(vector const& v) {
  return equal_words(hls::transform_normal(v.in, v.regs),
                     golden::transform_normal<golden::rounded>(as_golden<golden::transform_normal_in>(v.in),
                                                               as_golden<golden::transform_normal_regs>(v.regs)));
}

TEST(transform_normal, hls_equals_golden) { for_vectors<vector>(any_word(), hls_equals_golden); }

// The eye close to the plane through P' across N': N' . (P' - E) is a few LSB from zero.
TEST(transform_normal, hls_equals_golden_at_grazing_angles) {
  std::uint64_t away = 0, level = 0, seen = 0;
  for_vectors<vector>(
      [](vector& v, generator& g) {
        unit_vector(v.in.n, g);
        for (auto& row : v.regs.rotation) unit_vector(row, g);
        // Along (-n.y, n.x, 0), which is perpendicular, then at most an LSB off.
        const std::int64_t step = g.between(-400, 400);
        const std::int64_t off[3] = {-raw(v.in.n[1]) * step, raw(v.in.n[0]) * step, 0};
        for (int i = 0; i < 3; ++i) v.regs.eye[i] = hls::from_raw<formats::eye>(raw(v.in.p[i]) + off[i] + g.between(-1, 1));
      },
      [&](vector const& v) {
        ++seen;
        std::int64_t facing = 0;
        for (int i = 0; i < 3; ++i) facing += raw(v.in.n[i]) * (raw(v.in.p[i]) - raw(v.regs.eye[i]));
        const bool says = hls::transform_normal(v.in, v.regs).away;
        away += says ? 1 : 0;
        level += facing == 0 ? 1 : 0;
        if (says != (facing > 0)) return testing::AssertionFailure() << "N' . (P' - E) is " << facing << " LSB, away is " << says;
        return hls_equals_golden(v);
      });
  EXPECT_GT(away, seen / 4);
  EXPECT_GT(level, seen / 100) << "no right angles among the vectors";
}

TEST(transform_normal, a_quarter_turn_moves_the_components) {
  vector v{};
  v.regs.rotation[0][1] = hls::from_raw<formats::unit>(16384);
  v.regs.rotation[1][0] = hls::from_raw<formats::unit>(-16384);
  v.regs.rotation[2][2] = hls::from_raw<formats::unit>(16384);
  for (int i = 0; i < 3; ++i) v.in.n[i] = hls::from_raw<formats::unit>(1000 * (i + 1));
  const auto out = hls::transform_normal(v.in, v.regs);
  EXPECT_EQ(raw(out.n[0]), 2000);
  EXPECT_EQ(raw(out.n[1]), -1000);
  EXPECT_EQ(raw(out.n[2]), 3000);
  EXPECT_FALSE(out.away);
}

}  // namespace
}  // namespace relievo::test
