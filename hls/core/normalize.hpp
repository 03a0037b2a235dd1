// normalize: v / |v|, every component correctly rounded (half up) to a unit.
//   in    v         direction[3]
//         tangent   a zero vector becomes (1,0,0), else (0,0,1)
//   out   n         unit[3]
//         zero      |v| was 0 (counted by the engine)
//
//   A table of 192 reciprocal roots and one Newton step give q' with |q' - q| < 1 for the exact q = |v_i| 2^14 / |v|:
//     table    relative error e0 <= 1/(4 * 64.5); step: 1.5 e0^2 < 2.3e-5, times q <= 2^14: 0.38; truncations below 0.01; rounding 0.5.
//   Then the sign of (2q' +- 1)^2 |v|^2 - 4 v_i^2 2^28 settles the last bit exactly. That difference has at most 55 bits, so it is
//   computed modulo 2^64 and read as signed, though each of its two terms may have 68.
//   initiation interval 1
#pragma once
#include "hls/core/record.hpp"
#include "hls/core/vector.hpp"

namespace relievo {
namespace hls {

struct normalize_in {
  fixed<formats::direction> v[3];
  bool tangent;
  RELIEVO_FIELDS(v, tangent)
};
struct normalize_out {
  fixed<formats::unit> n[3];
  bool zero;
  RELIEVO_FIELDS(n, zero)
};

namespace detail {

struct reciprocal_root_table {
  static constexpr int first = 64, last = 255;
  std::uint32_t entry[last - first + 1];
};

constexpr std::uint64_t integer_root(std::uint64_t x) {
  std::uint64_t root = 0;
  for (int bit = 31; bit >= 0; --bit) {
    const std::uint64_t trial = root | (std::uint64_t(1) << bit);
    if (trial * trial <= x) root = trial;
  }
  return root;
}

// entry i is 2^20 / sqrt(i + 1/2).
constexpr reciprocal_root_table make_reciprocal_root_table() {
  reciprocal_root_table table{};
  for (int i = reciprocal_root_table::first; i <= reciprocal_root_table::last; ++i)
    table.entry[i - reciprocal_root_table::first] =
        static_cast<std::uint32_t>(integer_root((std::uint64_t(1) << 41) / static_cast<std::uint64_t>(2 * i + 1)));
  return table;
}
static constexpr reciprocal_root_table reciprocal_roots = make_reciprocal_root_table();

}  // namespace detail

inline normalize_out normalize(normalize_in const& in) {
  normalize_out out;
  const auto s0_square = dot(in.v, in.v);
  static_assert(decltype(s0_square)::format_type::width <= 40, "the squared length fits 36 bits, its type 38");
  const std::uint64_t square = static_cast<std::uint64_t>(raw(s0_square));
  out.zero = square == 0;

  // s1: m = |v|^2 4^j in [2^34, 2^36); a zero vector takes any way through.
  std::uint64_t m = out.zero ? 1 : square;
  int j = 0;
  for (int step = 16; step >= 1; step >>= 1) {
    if (m < (std::uint64_t(1) << (36 - 2 * step))) {
      m <<= 2 * step;
      j += step;
    }
  }
  const int entry = static_cast<int>(m >> 28) - detail::reciprocal_root_table::first;

  // s2: r = 2^34 / sqrt(m), one Newton step from the table: r (3 - m r^2 2^-68) / 2.
  const std::uint64_t r0 = detail::reciprocal_roots.entry[entry];
  const std::uint64_t residual = (std::uint64_t(3) << 54) - (m >> 14) * r0 * r0;
  const std::uint64_t r1 = (r0 * (residual >> 30)) >> 25;

  for (int i = 0; i < 3; ++i) {
    const std::int64_t v = raw(in.v[i]);
    const bool negative = v < 0;
    const std::uint64_t a = static_cast<std::uint64_t>(negative ? -v : v);
    // s3: the candidate, and s4: its last bit.
    std::uint64_t q = (a * r1 + (std::uint64_t(1) << (19 - j))) >> (20 - j);
    const std::uint64_t target = (a * a) << 30;
    const std::int64_t above = static_cast<std::int64_t>((2 * q + 1) * (2 * q + 1) * square - target);
    const std::int64_t below = static_cast<std::int64_t>((2 * q - 1) * (2 * q - 1) * square - target);
    // Half up: a positive component takes the upper neighbour on a tie, the magnitude of a negative one the lower.
    if (negative ? above < 0 : above <= 0)
      ++q;
    else if (q != 0 && (negative ? below >= 0 : below > 0))
      --q;
    out.n[i] = from_raw<formats::unit>(negative ? -static_cast<std::int64_t>(q) : static_cast<std::int64_t>(q));
  }
  if (out.zero) {
    const std::int64_t one = std::int64_t(1) << formats::unit::fraction;
    out.n[0] = from_raw<formats::unit>(in.tangent ? one : 0);
    out.n[1] = from_raw<formats::unit>(0);
    out.n[2] = from_raw<formats::unit>(in.tangent ? 0 : one);
  }
  return out;
}

}  // namespace hls
}  // namespace relievo
