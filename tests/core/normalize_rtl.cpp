// normalize: the circuit, which has a method of its own, equals the kernel, one vector a clock, 21 clocks later: on any words, on long and
// short vectors, on every word of a component, and on vectors next to a boundary between two words, which only the last digits tell apart.
#include <algorithm>
#include <cmath>

#include "Vnormalize.h"
#include "hls/core/normalize.hpp"
#include "tests/support/pipeline.hpp"

namespace relievo::test {
namespace {

struct in_only {
  hls::normalize_in in;
  RELIEVO_FIELDS(in)
};

template <class Shape>
void equals_kernel(Shape shape) {
  pipeline_test<Vnormalize, in_only>(21, shape, [](in_only const& v) { return hls::normalize(v.in); });
}
hls::fixed<formats::direction> word(std::int64_t x) { return hls::from_raw<formats::direction>(x); }

TEST(normalize, rtl_equals_hls) { equals_kernel(any_word()); }

// All 18 bits of one component beside two fixed ones.
TEST(normalize, rtl_equals_hls_on_every_word_of_a_component) {
  std::int64_t number = 0;
  const auto next = [&number](in_only& v, generator&) {
    v.in.v[0] = word(number % 262144 - 131072);
    v.in.v[1] = word(number / 262144 % 2 == 0 ? 1 : 16384);
    v.in.v[2] = word(3);
    ++number;
  };
  while (number < 2 * 262144 && !testing::Test::HasFailure()) equals_kernel(next);
}

// 5 bits a component, where zero, ties of length and powers of two are dense.
TEST(normalize, rtl_equals_hls_on_a_grid) {
  std::int64_t number = 0;
  const auto next = [&number](in_only& v, generator&) {
    for (int i = 0; i < 3; ++i) v.in.v[i] = word((number >> 5 * i & 31) - 16);
    v.in.tangent = (number >> 15 & 1) != 0;
    ++number;
  };
  while (number < 65536 && !testing::Test::HasFailure()) equals_kernel(next);
}

// For a boundary t/2^15 and a component v, the square of the other two that hits it exactly is v^2 (2^30 - t^2) / t^2. A first one below
// its root, and the second from what is left, come as near as the words allow: a few squares of 2^36.
TEST(normalize, rtl_equals_hls_next_to_a_boundary) {
  __extension__ typedef __int128 int128;
  std::uint64_t near = 0, seen = 0;
  pipeline_test<Vnormalize, in_only>(
      21,
      [](in_only& v, generator& g) {
        const std::int64_t t = 2 * g.between(8000, 16383) + 1, x = g.between(2000, 131071);
        const auto rest = static_cast<std::int64_t>(static_cast<int128>(x) * x * ((std::int64_t(1) << 30) - t * t) / (t * t));
        const auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(rest)));
        const std::int64_t y = g.chance(2) ? root : g.between(root / 2, root);
        const auto z = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(std::max<std::int64_t>(0, rest - y * y))))) +
                       g.between(0, 1);
        if (y > 131071 || z > 131071) return;
        const std::uint64_t turn = g.below(3);
        const std::int64_t words[3] = {x, y, z};
        for (std::uint64_t i = 0; i < 3; ++i) v.in.v[(i + turn) % 3] = word(g.chance(2) ? words[i] : -words[i]);
      },
      [&](in_only const& v) {
        std::int64_t square = 0;
        for (auto const& c : v.in.v) square += raw(c) * raw(c);
        const auto out = hls::normalize(v.in);
        bool close = false;
        for (int i = 0; i < 3 && square != 0; ++i) {
          const double exact = std::abs(static_cast<double>(raw(v.in.v[i]))) * 16384 / std::sqrt(static_cast<double>(square));
          close |= std::abs(exact - std::floor(exact) - 0.5) < 1e-3 && raw(out.n[i]) != 0;
        }
        ++seen;
        near += close ? 1 : 0;
        return out;
      });
  EXPECT_GT(near, seen / 4) << "the vectors miss the boundaries";
}

}  // namespace
}  // namespace relievo::test
