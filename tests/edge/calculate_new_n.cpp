// calculate_new_n: hls equals golden; exchanging the ends gives the same bits; opposite ends give the fallback; equal ends keep theirs.
#include "hls/edge/calculate_new_n.hpp"

#include <gtest/gtest.h>

#include "golden/edge/calculate_new_n.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using input = hls::calculate_new_n_in;

hls::fixed<formats::weight> weight(std::int64_t k) { return hls::from_raw<formats::weight>(k); }

testing::AssertionResult agrees(input const& in) {
  const auto out = hls::calculate_new_n(in);
  const auto result = equal_words(out, golden::calculate_new_n<golden::rounded>(as_golden<golden::calculate_new_n_in>(in)));
  if (!result) return result;
  input back = in;
  for (int i = 0; i < 3; ++i) {
    back.n1[i] = in.n2[i];
    back.n2[i] = in.n1[i];
  }
  back.k = weight(16 - raw(in.k));
  const auto symmetric = same_words(out, hls::calculate_new_n(back));
  return symmetric ? symmetric : testing::AssertionFailure() << "seen from the other end, " << symmetric.message();
}

TEST(calculate_new_n, hls_equals_golden_from_either_end) {
  for_vectors<input>([](input& in, generator&) { in.k = weight(raw(in.k) % 17); }, agrees);
}

TEST(calculate_new_n, hls_equals_golden_on_unit_vectors) {
  for_vectors<input>(
      [](input& in, generator& g) {
        in.k = weight(g.chance(2) ? 8 : g.between(0, 16));
        unit_vector(in.n1, g);
        unit_vector(in.n2, g);
      },
      agrees, vector_count() / 2);
}

TEST(calculate_new_n, hls_equals_golden_on_opposite_ends) {
  std::uint64_t zeros = 0;
  for_vectors<input>(
      [](input& in, generator& g) {
        in.k = weight(g.chance(4) ? g.between(7, 9) : 8);
        unit_vector(in.n1, g);
        for (int i = 0; i < 3; ++i) {
          const std::int64_t opposite = -raw(in.n1[i]);
          in.n2[i] = hls::from_raw<formats::unit>(opposite > 32767 ? 32767 : opposite);
          if (g.chance(2)) near(in.n2[i], in.n2[i], 1, g);
        }
      },
      [&](input const& in) {
        const auto out = hls::calculate_new_n(in);
        zeros += out.zero ? 1 : 0;
        if (out.zero && (raw(out.n[in.tangent ? 0 : 2]) != 16384 || raw(out.n[in.tangent ? 2 : 0]) != 0 || raw(out.n[1]) != 0))
          return testing::AssertionFailure() << "a zero vector, and not the fallback";
        return agrees(in);
      },
      vector_count() / 4);
  EXPECT_GT(zeros, vector_count() / 400);
}

// The direction register holds twice the mean: the midpoint of two words one LSB apart is not rounded before it is normalised.
TEST(calculate_new_n, the_midpoint_loses_nothing_before_it_is_normalised) {
  for_vectors<input>(
      [](input& in, generator& g) {
        in.k = weight(8);
        unit_vector(in.n1, g);
        for (int i = 0; i < 3; ++i) near(in.n2[i], in.n1[i], 5, g);
      },
      [](input const& in) {
        hls::normalize_in sum;
        sum.tangent = in.tangent;
        for (int i = 0; i < 3; ++i) sum.v[i] = hls::from_raw<formats::direction>(raw(in.n1[i]) + raw(in.n2[i]));
        const auto right = hls::normalize(sum);
        const auto out = hls::calculate_new_n(in);
        for (int i = 0; i < 3; ++i)
          if (raw(out.n[i]) != raw(right.n[i])) return testing::AssertionFailure() << "component " << i << " is not that of the sum";
        return testing::AssertionSuccess();
      },
      vector_count() / 10);
}

}  // namespace
}  // namespace relievo::test
