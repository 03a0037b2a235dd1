// reciprocal: 1 / x, correctly rounded (half up) to a format, saturated. The divider with a constant numerator.
//   in    x    unsigned
//   out   1/x  To; clipped |= it did not fit (x = 0 gives the largest value and counts as clipped)
//   initiation interval 1
#pragma once
#include "hls/core/divide.hpp"

namespace relievo {
namespace hls {

template <class To, class X>
inline fixed<To> reciprocal(fixed<X> x, bool& clipped) {
  return divide<To>(from_raw<format<1, 1, false>>(1), x, clipped);
}

}  // namespace hls
}  // namespace relievo
