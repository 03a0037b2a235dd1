// divide: correctly rounded, decided in integers: exhaustive on small formats, seeded random on the formats of the project, and equal to
// golden's quotient; ties, both ends of the range, a zero denominator.
#include "hls/core/divide.hpp"

#include <gtest/gtest.h>

#include "golden/core/quotient.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

__extension__ typedef __int128 int128;

// q is round half up of (n / d) 2^shift, saturated: (2 q - 1) d <= 2 n 2^shift < (2 q + 1) d wherever the bound on that side matters.
template <class To, class N, class D>
testing::AssertionResult correctly_rounded(hls::fixed<N> numerator, hls::fixed<D> denominator) {
  bool clipped = false;
  const std::int64_t q = raw(hls::divide<To>(numerator, denominator, clipped));
  const int128 d = raw(denominator);
  const int128 twice = static_cast<int128>(raw(numerator)) * (static_cast<int128>(2) << (To::fraction - N::fraction + D::fraction));
  const bool low_enough = (2 * static_cast<int128>(q) - 1) * d <= twice, high_enough = twice < (2 * static_cast<int128>(q) + 1) * d;
  const bool at_top = q == hls::fixed<To>::max_raw, at_bottom = q == hls::fixed<To>::min_raw;
  const bool right = (low_enough || at_bottom) && (high_enough || at_top) && q <= hls::fixed<To>::max_raw && q >= hls::fixed<To>::min_raw;
  const bool beyond = !low_enough || !high_enough;
  if (right && clipped == beyond) return testing::AssertionSuccess();
  return testing::AssertionFailure() << raw(numerator) << " / " << raw(denominator) << " gives " << q << ", clipped " << clipped;
}

template <class To, class N, class D>
void every_quotient() {
  for (std::int64_t n = hls::fixed<N>::min_raw; n <= hls::fixed<N>::max_raw; ++n)
    for (std::int64_t d = 1; d <= hls::fixed<D>::max_raw; ++d)
      ASSERT_TRUE((correctly_rounded<To>(hls::from_raw<N>(n), hls::from_raw<D>(d))));
}

using signed10 = format<10, 4, true>;
using unsigned10 = format<10, 5, false>;

TEST(divide, every_quotient_of_small_formats) {
  every_quotient<format<14, 6, true>, signed10, unsigned10>();
  every_quotient<format<12, 2, true>, signed10, unsigned10>();
  every_quotient<format<9, 3, false>, signed10, unsigned10>();
  every_quotient<format<12, 8, false>, unsigned10, format<10, 9, false>>();
}

template <class N, class D>
struct operands {
  hls::fixed<N> n;
  hls::fixed<D> d;
  RELIEVO_FIELDS(n, d)
};

// One in two numerators lies at or beside the boundary between two quotients: (2 q + 1) d / 2^(shift + 1).
template <class To, class N, class D>
void hard_case(operands<N, D>& v, generator& g) {
  constexpr int shift = To::fraction - N::fraction + D::fraction;
  if (raw(v.d) == 0) v.d = hls::from_raw<D>(1);
  if (g.chance(2)) return;
  const std::int64_t q = random_word<To>(draw::mixed, g);
  const int128 n = ((2 * static_cast<int128>(q) + 1) * raw(v.d) >> (shift + 1)) + g.between(0, 1);
  if (n <= hls::fixed<N>::max_raw && n >= hls::fixed<N>::min_raw) v.n = hls::from_raw<N>(static_cast<std::int64_t>(n));
}

template <class To, class N, class D>
void expect_correct() {
  for_vectors<operands<N, D>>(hard_case<To, N, D>, [](operands<N, D> const& v) {
    const auto result = correctly_rounded<To>(v.n, v.d);
    if (!result) return result;
    bool clipped = false, golden_clipped = false;
    const auto q = hls::divide<To>(v.n, v.d, clipped);
    const double golden = golden::quotient<golden::rounded, To, D::width>(
        std::ldexp(static_cast<double>(raw(v.n)), -N::fraction), std::ldexp(static_cast<double>(raw(v.d)), -D::fraction), golden_clipped);
    if (std::ldexp(static_cast<double>(raw(q)), -To::fraction) != golden || clipped != golden_clipped)
      return testing::AssertionFailure() << "golden " << golden << ", hls " << raw(q) << " LSB";
    return result;
  });
}

TEST(divide, hls_equals_golden_on_the_screen) { expect_correct<formats::screen, formats::clip, formats::depth>(); }
TEST(divide, hls_equals_golden_on_means) { expect_correct<formats::sample, formats::table_sum, formats::area>(); }

template <class To>
std::int64_t quotient_of(std::int64_t n, std::int64_t d, bool& clipped) {
  return raw(hls::divide<To>(hls::from_raw<format<12, 12, true>>(n), hls::from_raw<format<12, 12, false>>(d), clipped));
}

TEST(divide, ties_round_up) {
  using whole = format<10, 10, true>;
  bool clipped = false;
  EXPECT_EQ(quotient_of<whole>(5, 2, clipped), 3);
  EXPECT_EQ(quotient_of<whole>(-5, 2, clipped), -2);
  EXPECT_EQ(quotient_of<whole>(-1, 2, clipped), 0);
  EXPECT_EQ(quotient_of<whole>(-3, 2, clipped), -1);
  EXPECT_EQ(quotient_of<whole>(-4, 3, clipped), -1);
  EXPECT_FALSE(clipped);
}

TEST(divide, a_zero_denominator_saturates_by_the_sign) {
  using whole = format<10, 10, true>;
  for (const std::int64_t n : {-7, 0, 7}) {
    bool clipped = false;
    EXPECT_EQ(quotient_of<whole>(n, 0, clipped), n < 0 ? -512 : 511);
    EXPECT_TRUE(clipped);
  }
}

TEST(divide, the_flag_is_never_cleared) {
  bool clipped = true;
  quotient_of<format<10, 10, true>>(1, 1, clipped);
  EXPECT_TRUE(clipped);
}

}  // namespace
}  // namespace relievo::test
