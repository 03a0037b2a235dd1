// quantise: values of the user's brought into a format once, round half up; what does not fit is refused, never clipped.
#pragma once
#include <cmath>
#include <sstream>
#include <string>

#include "hls/core/formats.hpp"
#include "tb/host/input_error.hpp"

namespace relievo::tb {

template <class F>
double lsb_of() {
  return std::ldexp(1.0, -F::fraction);
}
template <class F>
double max_of() {
  return (std::ldexp(1.0, F::width - (F::is_signed ? 1 : 0)) - 1.0) * lsb_of<F>();
}
template <class F>
double min_of() {
  return F::is_signed ? -std::ldexp(1.0, F::integer_bits - 1) : 0.0;
}

// The nearest value of format F, halves up; without regard to its range.
template <class F>
double round_half_up(double x) {
  const double scaled = std::ldexp(x, F::fraction);
  const double below = std::floor(scaled);
  // A word has one zero.
  return std::ldexp(scaled - below >= 0.5 ? below + 1.0 : below, -F::fraction) + 0.0;
}

template <class F>
bool fits(double x) {
  const double q = round_half_up<F>(x);
  return q >= min_of<F>() && q <= max_of<F>();
}

// A number as a message shows it.
inline std::string shown(double x) {
  std::ostringstream text;
  text.precision(9);
  text << x;
  return text.str();
}

// `what` names the option and its unit; `per_unit` is how many of the format's units one of the user's units is, for the message alone.
template <class F>
double quantise(double x, std::string const& what, double per_unit = 1.0) {
  if (!std::isfinite(x) || !fits<F>(x))
    throw input_error(what + ": " + shown(x / per_unit) + " does not fit; from " + shown(min_of<F>() / per_unit) + " to " +
                      shown(max_of<F>() / per_unit) + " is possible");
  return round_half_up<F>(x);
}

}  // namespace relievo::tb
