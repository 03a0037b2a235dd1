// displace: hls equals golden; what is special: the height register clips before the position does, and each is flagged.
#include "hls/surface/displace.hpp"

#include <gtest/gtest.h>

#include "golden/surface/displace.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::displace_in, hls::displace_regs>;

testing::AssertionResult hls_equals_golden(vector const& v) {
  return equal_words(hls::displace(v.in, v.regs),
                     golden::displace<golden::rounded>(as_golden<golden::displace_in>(v.in), as_golden<golden::displace_regs>(v.regs)));
}

TEST(displace, hls_equals_golden) { for_vectors<vector>(any_word(), hls_equals_golden); }

TEST(displace, hls_equals_golden_in_a_plausible_scene) {
  for_vectors<vector>(
      [](vector& v, generator& g) {
        unit_vector(v.in.n, g);
        v.regs.scale = hls::from_raw<formats::scale>(raw(v.regs.scale) >> 3);
        v.regs.bias = hls::from_raw<formats::height>(raw(v.regs.bias) >> 3);
        for (auto& p : v.in.p) p = hls::from_raw<formats::position>(raw(p) >> 1);
      },
      [](vector const& v) {
        const auto out = hls::displace(v.in, v.regs);
        if (out.saturated) return testing::AssertionFailure() << "nothing here is large enough to clip";
        return hls_equals_golden(v);
      });
}

vector at_rest() {
  vector v{};
  v.in.n[2] = hls::from_raw<formats::unit>(16384);
  return v;
}

TEST(displace, rounds_half_up_at_both_registers) {
  vector v = at_rest();
  // s D is half an LSB of height: 2^-21 = 2^-36 * 2^15.
  v.regs.scale = hls::from_raw<formats::scale>(1);
  v.in.d = hls::from_raw<formats::sample>(std::int64_t(1) << 19);
  EXPECT_EQ(raw(hls::displace(v.in, v.regs).p[2]), 1);
  v.regs.scale = hls::from_raw<formats::scale>(-1);
  EXPECT_EQ(raw(hls::displace(v.in, v.regs).p[2]), 0) << "minus half an LSB rounds up to zero";
  // Half an LSB of position: height of one LSB along a normal of one half.
  v = at_rest();
  v.regs.bias = hls::from_raw<formats::height>(1);
  v.in.n[0] = hls::from_raw<formats::unit>(8192);
  v.in.n[1] = hls::from_raw<formats::unit>(-8192);
  EXPECT_EQ(raw(hls::displace(v.in, v.regs).p[0]), 1);
  EXPECT_EQ(raw(hls::displace(v.in, v.regs).p[1]), 0);
}

TEST(displace, flags_each_register_that_clips) {
  vector v = at_rest();
  v.in.p[2] = hls::from_raw<formats::position>(hls::fixed<formats::position>::max_raw);
  EXPECT_FALSE(hls::displace(v.in, v.regs).saturated);
  v.regs.bias = hls::from_raw<formats::height>(1);
  EXPECT_TRUE(hls::displace(v.in, v.regs).saturated);
  EXPECT_EQ(raw(hls::displace(v.in, v.regs).p[2]), hls::fixed<formats::position>::max_raw);
  // The height clips although the position is back in range where the normal is short.
  v = at_rest();
  v.in.n[2] = hls::from_raw<formats::unit>(1);
  v.regs.scale = hls::from_raw<formats::scale>(hls::fixed<formats::scale>::max_raw);
  v.in.d = hls::from_raw<formats::sample>(hls::fixed<formats::sample>::max_raw);
  v.regs.bias = hls::from_raw<formats::height>(hls::fixed<formats::height>::max_raw);
  EXPECT_TRUE(hls::displace(v.in, v.regs).saturated);
}

}  // namespace
}  // namespace relievo::test
