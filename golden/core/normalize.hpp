// normalize: n = v / |v|, each component correctly rounded (half up).             Doggett & Hirche 2000, eq. 1 (N-hat)
//
//   in   v   direction     any vector
//        tangent           a zero vector becomes (1, 0, 0), else (0, 0, 1)
//   out  n   unit          zero: |v| was 0
//   registers: unit
//
// Double alone does not decide the last bit: (6354, 2707, 9352) / |.| gives 8955 where 8954 is right. The word r is the
// largest integer with 2r - 1 <= 2^15 v / |v|, and that comparison is made between squares in 128 bits.
#pragma once
#include <cassert>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct normalize_in {
  glm::dvec3 v{0};
  bool tangent = false;
  RELIEVO_FIELDS(v, tangent)
};
struct normalize_out {
  glm::dvec3 n{0};
  bool zero = false;
  RELIEVO_FIELDS(n, zero)
};

namespace detail {

__extension__ typedef __int128 int128;

// The raw word floor(2^F v / sqrt(square) + 1/2), decided in integers. v^2 <= square < 2^40.
template <int F>
std::int64_t rounded_ratio(std::int64_t v, std::int64_t square) {
  // (2r - 1) sqrt(square) <= 2^(F+1) v, by signs first, then by squares.
  const auto reached = [v, square](std::int64_t r) {
    const std::int64_t odd = 2 * r - 1;
    if (odd < 0 && v >= 0) return true;
    if (odd > 0 && v < 0) return false;
    const int128 left = static_cast<int128>(odd) * odd * square;
    const int128 right = (static_cast<int128>(v) * v) * (static_cast<int128>(1) << (2 * F + 2));
    return odd > 0 ? left <= right : left >= right;
  };
  auto r = static_cast<std::int64_t>(round_half_up(static_cast<double>(v) * power_of_two(F) / std::sqrt(static_cast<double>(square))));
  while (!reached(r)) --r;
  while (reached(r + 1)) ++r;
  return r;
}

}  // namespace detail

template <class Rounding>
normalize_out normalize(normalize_in const& in) {
  const normalize_out nothing{in.tangent ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1), true};
  if constexpr (Rounding::is_exact) {
    const double length = glm::length(in.v);
    if (length <= Rounding::noise(1)) return nothing;
    return {in.v / length, false};
  } else {
    static_assert(2 * formats::direction::width + 2 <= 40, "the square of the length must fit rounded_ratio");
    std::int64_t raw[3];
    std::int64_t square = 0;
    for (int i = 0; i < 3; ++i) {
      const double scaled = in.v[i] * power_of_two(formats::direction::fraction);
      raw[i] = static_cast<std::int64_t>(scaled);
      assert(static_cast<double>(raw[i]) == scaled && "v must be a word of its format");
      square += raw[i] * raw[i];
    }
    if (square == 0) return nothing;
    normalize_out out;
    for (int i = 0; i < 3; ++i)
      out.n[i] = static_cast<double>(detail::rounded_ratio<formats::unit::fraction>(raw[i], square)) * range_of<formats::unit>::lsb;
    return out;
  }
}

}  // namespace golden
}  // namespace relievo
