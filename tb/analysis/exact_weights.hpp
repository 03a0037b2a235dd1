// exact_weights: barycentric weights in a base triangle as integers times 2^60, and what is decided with them, without rounding.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

namespace relievo::tb::exact_weights {

__extension__ typedef __int128 int128;
inline constexpr std::int64_t one = std::int64_t{1} << 60;

using weights = std::array<std::int64_t, 3>;

// Twice the area over the base triangle's, times 2^120. Differences of weights are at most 2^60: no overflow.
inline int128 area(weights const& a, weights const& b, weights const& c) {
  return static_cast<int128>(b[0] - a[0]) * (c[1] - a[1]) - static_cast<int128>(b[1] - a[1]) * (c[0] - a[0]);
}

// x strictly between a and b on their line.
inline bool strictly_between(weights const& x, weights const& a, weights const& b) {
  if (x == a || x == b || area(a, b, x) != 0) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (x[k] < std::min(a[k], b[k]) || x[k] > std::max(a[k], b[k])) return false;
  }
  return true;
}

inline bool is_inside(weights const& w) {
  for (const std::int64_t x : w) {
    if (x < 0 || x > one) return false;
  }
  return w[0] + w[1] + w[2] == one;
}

// The side k, from corner k to corner k + 1, that both points lie on, or 3.
inline std::size_t side_of(weights const& a, weights const& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a[(k + 2) % 3] == 0 && b[(k + 2) % 3] == 0) return k;
  }
  return 3;
}

}  // namespace relievo::tb::exact_weights
