// rounding: the two readings of every golden formula, chosen by a template parameter.
//
//   rounded   what the hardware holds: at<F>(x) rounds the exact value x half up to format F and saturates to F's range.
//   exact     what the paper means: at<F>(x) is x. Nothing saturates. Doubles stand for real numbers, so two values that
//             differ by no more than double's own noise count as equal in a comparison (exceeds).
//
// A double is the exact value before rounding only while it fits 53 bits; `bits` computes the width of sums and products
// at compile time, and every unit asserts fits_double on what it rounds or compares.
#pragma once
#include <cmath>
#include <cstdint>

#include "hls/core/formats.hpp"

namespace relievo {
namespace golden {

// How many bits an exact intermediate needs, in front of the binary point (sign included) and behind it.
struct bits {
  int integer;
  int fraction;
};
template <class F>
constexpr bits bits_of() {
  return {F::integer_bits, F::fraction};
}
constexpr bits operator*(bits a, bits b) { return {a.integer + b.integer, a.fraction + b.fraction}; }
constexpr bits operator+(bits a, bits b) {
  return {(a.integer > b.integer ? a.integer : b.integer) + 1, a.fraction > b.fraction ? a.fraction : b.fraction};
}
// Products of two formats, summed over the components of a 3-vector (two more bits hold a factor of 3).
constexpr bits dot3(bits a, bits b) { return {a.integer + b.integer + 2, a.fraction + b.fraction}; }
constexpr bool fits_double(bits b) { return b.integer + b.fraction <= 53; }

constexpr double power_of_two(int e) {
  double p = 1;
  for (; e > 0; --e) p *= 2;
  for (; e < 0; ++e) p /= 2;
  return p;
}

template <class F>
struct range_of {
  static constexpr double lsb = power_of_two(-F::fraction);
  static constexpr double raw_max = power_of_two(F::is_signed ? F::width - 1 : F::width) - 1;
  static constexpr double raw_min = F::is_signed ? -power_of_two(F::width - 1) : 0;
  static constexpr double max = raw_max * lsb;
  static constexpr double min = raw_min * lsb;
};

// floor(x + 1/2) without forming x + 1/2, which a double may not hold.
inline double round_half_up(double x) {
  const double below = std::floor(x);
  return x - below >= 0.5 ? below + 1 : below;
}

struct rounded {
  static constexpr bool is_exact = false;

  template <class F>
  static double at(double x, bool& clipped) {
    static_assert(F::width <= 53, "a word must fit a double");
    using range = range_of<F>;
    const double raw = round_half_up(x * power_of_two(F::fraction));
    if (raw > range::raw_max) {
      clipped = true;
      return range::max;
    }
    if (raw < range::raw_min) {
      clipped = true;
      return range::min;
    }
    return raw * range::lsb;
  }
  template <class F>
  static double at(double x) {
    bool clipped = false;
    return at<F>(x, clipped);
  }
  static bool exceeds(double measure, double threshold, double) { return measure > threshold; }
  static constexpr double noise(double) { return 0; }
};

struct exact {
  static constexpr bool is_exact = true;

  template <class F>
  static double at(double x, bool&) {
    return x;
  }
  template <class F>
  static double at(double x) {
    return x;
  }
  // `scale` is the magnitude of the operands that the measure was computed from.
  static bool exceeds(double measure, double threshold, double scale) { return measure - threshold > noise(scale); }
  static constexpr double noise(double scale) { return scale * power_of_two(-40); }
};

}  // namespace golden
}  // namespace relievo
