// perspective_preparation: hls equals golden; c is 2^exponent / w, w to 24 significant bits, correctly rounded in integers; every component
// rounded once; block exponents; the nearest corner keeps all bits but one.
#include "hls/sweep/perspective_preparation.hpp"

#include <gtest/gtest.h>

#include "golden/sweep/perspective_preparation.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

__extension__ typedef __int128 int128;
using input = hls::perspective_preparation_in;

int leading_bit(std::int64_t x) {
  int index = 0;
  while (x >> index > 1) ++index;
  return index;
}
// Into the domain: w > 0, and the block's smallest w is not above it.
void domain(input& in, generator& g) {
  if (raw(in.w) == 0) in.w = hls::from_raw<formats::depth>(1);
  const int top = leading_bit(raw(in.w));
  in.exponent =
      hls::from_raw<hls::block_power::format_type>(g.chance(4) ? g.between(0, top) : std::max<std::int64_t>(top - g.between(0, 14), 0));
}

// floor(x + 1/2) of a quotient of positive numbers.
int128 nearest(int128 numerator, int128 denominator) { return (2 * numerator + denominator) / (2 * denominator); }

testing::AssertionResult right(input const& in) {
  const std::int64_t w = raw(in.w);
  const int beyond = std::max(leading_bit(w) - 23, 0);
  const int128 m = nearest(w, std::int64_t{1} << beyond) << beyond;
  const auto c = static_cast<std::int64_t>(nearest(int128{1} << (raw(in.exponent) + 26), m));
  const hls::interpolants out = hls::perspective_preparation(in);
  const auto fails = [&](char const* what) { return testing::AssertionFailure() << what << ", c " << c << "\n" << describe(out); };
  if (raw(out.c) != c) return fails("c");
  if (c < 0 || c > std::int64_t{1} << 26) return fails("c is not within [0, 1]");
  const auto component = [c](auto const& x, auto const& y) {
    using from = typename std::remove_reference_t<decltype(x)>::format_type;
    using to = typename std::remove_reference_t<decltype(y)>::format_type;
    const int128 product = int128{raw(x)} * c;
    return raw(y) == static_cast<std::int64_t>((product + (int128{1} << (from::fraction + 25 - to::fraction))) >>
                                               (from::fraction + 26 - to::fraction));
  };
  bool good = true;
  for (int i = 0; i < 3; ++i)
    good &= component(in.vertex.p[i], out.p[i]) && component(in.vertex.n[i], out.n[i]) && component(in.vertex.t[i], out.t[i]);
  for (int i = 0; i < 2; ++i) good &= component(in.vertex.u[i], out.u[i]);
  for (int i = 0; i < 4; ++i) good &= component(in.vertex.colour[i], out.colour[i]);
  if (!good) return fails("a component");
  return equal_words(out, golden::perspective_preparation(as_golden<golden::perspective_preparation_in>(in)));
}

TEST(perspective_preparation, hls_equals_golden_and_every_register_is_rounded_once) { for_vectors<input>(domain, right); }

// Where w has more bits than its mantissa: at and beside the ties, and where the mantissa becomes 2^24.
TEST(perspective_preparation, w_at_its_rounding_boundaries) {
  generator g = next_generator();
  input in{};
  draw_vector(in, draw::uniform, g);
  for (int bits = 24; bits <= 28; ++bits)
    for (const std::int64_t mantissa : {std::int64_t{1} << 23, (std::int64_t{1} << 23) + 1, (std::int64_t{1} << 24) - 1})
      for (std::int64_t off = 0; off < std::int64_t{1} << (bits - 24); ++off) {
        in.w = hls::from_raw<formats::depth>((mantissa << (bits - 24)) + off);
        for (int exponent = 0; exponent < bits; ++exponent) {
          in.exponent = hls::from_raw<hls::block_power::format_type>(exponent);
          ASSERT_TRUE(right(in)) << describe(in);
        }
      }
}

TEST(perspective_preparation, every_small_w) {
  input in{};
  for (std::int64_t w = 1; w < 1 << 12; ++w)
    for (int exponent = 0; exponent <= leading_bit(w); ++exponent) {
      in.w = hls::from_raw<formats::depth>(w);
      in.exponent = hls::from_raw<hls::block_power::format_type>(exponent);
      ASSERT_TRUE(right(in)) << describe(in);
    }
}

TEST(perspective_preparation, a_block_has_the_power_of_its_nearest_corner) {
  generator g = next_generator();
  const auto depth = [&g] { return hls::from_raw<formats::depth>(random_word<formats::depth>(draw::magnitude, g) | 1); };
  for (std::uint64_t round = 0; round < vector_count() / 10; ++round) {
    const hls::fixed<formats::depth> w[3] = {depth(), depth(), depth()};
    const std::int64_t two = std::min(raw(w[0]), raw(w[1])), three = std::min(two, raw(w[2]));
    ASSERT_EQ(raw(hls::block_exponent(w[0], w[1])), leading_bit(two));
    ASSERT_EQ(raw(hls::block_exponent(w[0], w[1], w[2])), leading_bit(three));
    ASSERT_EQ(raw(hls::block_exponent(w[1], w[0])), leading_bit(two));
    double depths[3];
    for (int i = 0; i < 3; ++i) depths[i] = static_cast<double>(raw(w[i])) / (1 << formats::depth::fraction);
    ASSERT_EQ(golden::block_exponent(depths[0], depths[1]), leading_bit(two));
    ASSERT_EQ(golden::block_exponent(depths[0], depths[1], depths[2]), leading_bit(three));
    // The nearest corner has c in (1/2, 1], and no corner less than 2^25 w_min / w_max LSB.
    for (auto const& one : w) {
      const auto c = raw(hls::perspective_preparation({{}, one, hls::block_exponent(w[0], w[1], w[2])}).c);
      ASSERT_GE(c, (std::int64_t{1} << 25) * three / raw(one));
      if (raw(one) == three) {
        ASSERT_GT(c, std::int64_t{1} << 25);
      }
    }
  }
}

}  // namespace
}  // namespace relievo::test
