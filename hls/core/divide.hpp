// divide: numerator / denominator, correctly rounded (half up) to a format, saturated.
//   in    numerator    any format
//         denominator  unsigned
//   out   quotient To, round half up of the exact quotient; clipped |= it did not fit
//   errors: a zero denominator saturates by the numerator's sign (0/0 to the top) and counts as clipped
//
//   The language's integer division is the one every HLS tool maps to its pipelined divider. The quotient of 2 n 2^s + d by 2 d,
//   floored, is the half-up rounding without a remainder test. Golden, of 53 bits, is right where bits(denominator) + bits(To) <= 52.
//   initiation interval 1
#pragma once
#include "hls/core/fixed.hpp"

namespace relievo {
namespace hls {

namespace detail {
// Half up, of integers; the denominator is above 0, and twice the numerator and the denominator fit 63 bits together.
inline std::int64_t rounded_quotient(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t dividend = 2 * numerator + denominator, divisor = 2 * denominator;
  const std::int64_t truncated = dividend / divisor;
  return truncated - (truncated * divisor > dividend ? 1 : 0);
}
}  // namespace detail

template <class To, class N, class D>
inline fixed<To> divide(fixed<N> numerator, fixed<D> denominator, bool& clipped) {
  constexpr int shift = To::fraction - N::fraction + D::fraction;
  static_assert(!D::is_signed, "the denominator is unsigned");
  static_assert(shift >= 0, "the quotient's fraction must not be coarser than the operands'");
  static_assert(N::width + shift + 1 <= 62 && D::width + 1 <= 62, "an intermediate is wider than 64 bits");
  static_assert(D::width + To::width <= 52, "golden, which has 53 bits, would not be correctly rounded");
  const std::int64_t d = raw(denominator);
  if (d == 0) {
    clipped = true;
    return from_raw<To>(raw(numerator) < 0 ? fixed<To>::min_raw : fixed<To>::max_raw);
  }
  const std::int64_t quotient = detail::rounded_quotient(raw(numerator) * (std::int64_t(1) << shift), d);
  return round_to<To>(from_raw<format<64, 64 - To::fraction, true>>(quotient), clipped);
}

}  // namespace hls
}  // namespace relievo
