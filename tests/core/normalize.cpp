// normalize: hls equals golden, and both equal an exact comparison of squares in 128 bits: every vector of a small grid, a million random
// ones, and the vectors nearest to a rounding boundary, searched for.
//
// There is no tie to round: v_i/|v| = t/2^15 with t odd asks for v_j^2 + v_k^2 = m^2 (2^30 - t^2) with v_i = t m, and 2^30 - t^2 is
// 7 modulo 8, so it has a prime 4a + 3 to an odd power and no multiple of it by a square is a sum of two squares.
#include "hls/core/normalize.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "golden/core/normalize.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

__extension__ typedef __int128 int128;

using input = hls::normalize_in;

// r is round half up of 2^14 v / |v|: (2 r - 1) |v| <= 2^15 v < (2 r + 1) |v|, each side by its sign, then by squares.
bool at_most(std::int64_t a, std::int64_t square, std::int64_t b, bool or_equal) {  // a sqrt(square) <= b, or <
  const int128 left = static_cast<int128>(a) * a * square, right = static_cast<int128>(b) * b;
  if (a < 0 && b >= 0) return square > 0 || or_equal;
  if (a >= 0 && b < 0) return false;
  if (a < 0) return or_equal ? left >= right : left > right;
  return or_equal ? left <= right : left < right;
}

testing::AssertionResult correctly_rounded(input const& in) {
  const hls::normalize_out out = hls::normalize(in);
  std::int64_t square = 0;
  for (auto const& v : in.v) square += raw(v) * raw(v);
  if (out.zero != (square == 0)) return testing::AssertionFailure() << "zero is " << out.zero;
  for (int i = 0; i < 3; ++i) {
    const std::int64_t v = raw(in.v[i]), r = raw(out.n[i]);
    if (square == 0) {
      if (r != (i == (in.tangent ? 0 : 2) ? 16384 : 0)) return testing::AssertionFailure() << "zero vector gives " << r << " for " << i;
      continue;
    }
    const std::int64_t scaled = v * (std::int64_t(1) << 15);
    if (!at_most(2 * r - 1, square, scaled, true)) return testing::AssertionFailure() << "component " << i << " = " << r << " is too large";
    if (at_most(2 * r + 1, square, scaled, true)) return testing::AssertionFailure() << "component " << i << " = " << r << " is too small";
  }
  const auto golden = golden::normalize<golden::rounded>(as_golden<golden::normalize_in>(in));
  for (int i = 0; i < 3; ++i)
    if (golden.n[i] * 16384 != static_cast<double>(raw(out.n[i])))
      return testing::AssertionFailure() << "component " << i << ": hls " << raw(out.n[i]) << ", golden " << golden.n[i] * 16384;
  if (golden.zero != out.zero) return testing::AssertionFailure() << "golden says zero is " << golden.zero;
  return testing::AssertionSuccess();
}

input at(std::int64_t x, std::int64_t y, std::int64_t z) {
  return {{hls::from_raw<formats::direction>(x), hls::from_raw<formats::direction>(y), hls::from_raw<formats::direction>(z)}, false};
}

TEST(normalize, hls_equals_golden) { for_vectors<input>(any_word(), correctly_rounded); }

// 7 + 7 + 6 bits.
TEST(normalize, every_vector_of_a_grid_of_20_bits) {
  for (std::int64_t x = -64; x < 64; ++x)
    for (std::int64_t y = -64; y < 64; ++y)
      for (std::int64_t z = -32; z < 32; ++z) ASSERT_TRUE(correctly_rounded(at(x, y, z))) << x << ", " << y << ", " << z;
}

// All 18 bits of one component beside two fixed ones.
TEST(normalize, every_word_of_a_component) {
  for (const std::int64_t y : {0, 1, 16384, -131072})
    for (std::int64_t x = -131072; x < 131072; ++x) ASSERT_TRUE(correctly_rounded(at(x, y, 3))) << x << ", " << y;
}

TEST(normalize, the_known_hard_word) {
  const auto out = hls::normalize(at(6354, 2707, 9352));
  EXPECT_EQ(raw(out.n[0]), 8954) << "double alone gives 8955";
}

TEST(normalize, twice_a_vector_has_the_same_direction) {
  generator g("twice");
  for (int i = 0; i < 100000; ++i) {
    input in = at(g.between(-65536, 65535), g.between(-65536, 65535), g.between(-65536, 65535));
    const auto once = hls::normalize(in);
    for (auto& v : in.v) v = hls::from_raw<formats::direction>(2 * raw(v));
    const auto twice = hls::normalize(in);
    for (int c = 0; c < 3; ++c) ASSERT_EQ(raw(once.n[c]), raw(twice.n[c])) << describe(in);
  }
}

// a^2 + b^2 = s with both below 2^17, or nothing.
bool two_squares(std::int64_t s, std::int64_t& a, std::int64_t& b) {
  if (s % 4 == 3) return false;
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(s)));
  for (a = std::min<std::int64_t>(root, 131071); 2 * a * a >= s; --a) {
    const std::int64_t rest = s - a * a;
    if (rest < 0) continue;
    b = static_cast<std::int64_t>(std::sqrt(static_cast<double>(rest)));
    if (b * b == rest) return true;
  }
  return false;
}

// For a boundary t/2^15 between two words and a component v, the square of the other two that would hit it exactly is
// v^2 (2^30 - t^2) / t^2; the sums of two squares next to it make the hardest vectors there are, all within 2^-14 LSB of the boundary.
TEST(normalize, the_vectors_nearest_to_a_boundary) {
  generator g("hard");
  const std::uint64_t wanted = vector_count() / 200 + 20;
  std::uint64_t found = 0, rounds = 0;
  while (found < wanted) {
    ASSERT_LT(++rounds, 100 * wanted + 1000) << "the search finds nothing";
    const std::int64_t t = 2 * g.between(2000, 16383) + 1;
    const std::int64_t v = g.between(20000, 131071);
    const int128 exact = static_cast<int128>(v) * v * ((std::int64_t(1) << 30) - t * t) / (t * t);
    if (exact < 2 || exact > (int128(1) << 34)) continue;
    for (std::int64_t s = static_cast<std::int64_t>(exact) - 2; s <= static_cast<std::int64_t>(exact) + 3; ++s) {
      std::int64_t a = 0, b = 0;
      if (s < 0 || !two_squares(s, a, b)) continue;
      ++found;
      std::int64_t word[3] = {v, a, b};
      std::sort(word, word + 3);
      do {
        for (int signs = 0; signs < 8; ++signs) {
          const auto sign = [signs](int i, std::int64_t x) { return (signs >> i & 1) != 0 ? -x : x; };
          ASSERT_TRUE(correctly_rounded(at(sign(0, word[0]), sign(1, word[1]), sign(2, word[2]))))
              << word[0] << ", " << word[1] << ", " << word[2] << ", signs " << signs;
        }
      } while (std::next_permutation(word, word + 3));
    }
  }
}

TEST(normalize, powers_of_two_and_the_ends) {
  for (int i = 0; i < 17; ++i)
    for (int k = 0; k < 17; ++k)
      for (const std::int64_t x : {-131072, -131071, 0, 1, 131071})
        ASSERT_TRUE(correctly_rounded(at(std::int64_t(1) << i, -(std::int64_t(1) << k), x))) << i << ", " << k << ", " << x;
  const auto out = hls::normalize(at(-131072, 0, 0));
  EXPECT_EQ(raw(out.n[0]), -16384);
}

}  // namespace
}  // namespace relievo::test
