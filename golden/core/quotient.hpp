// quotient: a / b, correctly rounded (half up) and saturated to format Out.
//
// With a divisor of DivisorBits bits and a quotient of Out::width bits, an a/b that is no tie lies at least 1/(2|b|) of an
// LSB away from one, and a double near a tie is finer than that while DivisorBits + Out::width <= 52: rounding the double
// quotient rounds the real one. Larger quotients saturate, and division is monotone.
// The divisor is an integer times a power of two; b != 0.
#pragma once
#include "golden/core/rounding.hpp"

namespace relievo {
namespace golden {

template <class Rounding, class Out, int DivisorBits>
double quotient(double a, double b, bool& clipped) {
  static_assert(DivisorBits + Out::width <= 52, "the double quotient would not decide the last bit");
  return Rounding::template at<Out>(a / b, clipped);
}

}  // namespace golden
}  // namespace relievo
