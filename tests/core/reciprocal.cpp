// reciprocal: every word of a 20-bit format, correctly rounded as integers decide it.
#include "hls/core/reciprocal.hpp"

#include <gtest/gtest.h>

namespace relievo::test {
namespace {

// 1/x for x in sixteenths of a sample, to 24 bits after the point: 2^28 / raw, rounded half up.
TEST(reciprocal, every_sample) {
  using to = format<29, 5, false>;
  for (std::int64_t x = 1; x <= hls::fixed<formats::sample>::max_raw; ++x) {
    bool clipped = false;
    const std::int64_t r = raw(hls::reciprocal<to>(hls::from_raw<formats::sample>(x), clipped));
    ASSERT_TRUE((2 * r - 1) * x <= (std::int64_t(1) << 29) && (std::int64_t(1) << 29) < (2 * r + 1) * x) << "1 / " << x << " gives " << r;
    ASSERT_FALSE(clipped) << x;
  }
}

TEST(reciprocal, saturates_where_the_format_ends) {
  using to = format<8, 2, false>;
  for (std::int64_t x = 0; x < 64; ++x) {
    bool clipped = false;
    const std::int64_t r = raw(hls::reciprocal<to>(hls::from_raw<format<6, 0, false>>(x), clipped));
    // 1/x = 64/x in units of one, 4096/x in sixty-fourths.
    const std::int64_t right = x == 0 ? 256 : (2 * 4096 + x) / (2 * x);
    EXPECT_EQ(r, right > 255 ? 255 : right) << x;
    EXPECT_EQ(clipped, right > 255) << x;
  }
}

}  // namespace
}  // namespace relievo::test
