// calculate_new_p: hls equals golden; exchanging the ends gives the same bits; the ends themselves, and ties at the midpoint.
#include "hls/edge/calculate_new_p.hpp"

#include <gtest/gtest.h>

#include "golden/edge/calculate_new_p.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using input = hls::calculate_new_p_in;

hls::fixed<formats::weight> weight(std::int64_t k) { return hls::from_raw<formats::weight>(k); }
void sixteenths(input& in, generator&) { in.k = weight(raw(in.k) % 17); }

testing::AssertionResult agrees(input const& in) {
  const auto out = hls::calculate_new_p(in);
  const auto result = equal_words(out, golden::calculate_new_p<golden::rounded>(as_golden<golden::calculate_new_p_in>(in)));
  if (!result) return result;
  input back = in;
  for (int i = 0; i < 3; ++i) {
    back.p1[i] = in.p2[i];
    back.p2[i] = in.p1[i];
    // Independent of both: (16 sum + 8) / 16, floored.
    const std::int64_t sum = raw(in.p1[i]) * (16 - raw(in.k)) + raw(in.p2[i]) * raw(in.k);
    if (raw(out.p[i]) != (sum + 8) >> 4) return testing::AssertionFailure() << "component " << i << " should be " << ((sum + 8) >> 4);
  }
  back.k = weight(16 - raw(in.k));
  const auto symmetric = same_words(out, hls::calculate_new_p(back));
  return symmetric ? symmetric : testing::AssertionFailure() << "seen from the other end, " << symmetric.message();
}

TEST(calculate_new_p, hls_equals_golden_from_either_end) { for_vectors<input>(sixteenths, agrees); }

TEST(calculate_new_p, hls_equals_golden_on_short_edges) {
  for_vectors<input>(
      [](input& in, generator& g) {
        sixteenths(in, g);
        if (g.chance(2)) in.k = weight(8);
        for (int i = 0; i < 3; ++i) near(in.p2[i], in.p1[i], 3, g);
      },
      agrees);
}

TEST(calculate_new_p, weights_0_and_16_are_the_ends) {
  for_vectors<input>(
      any_word(),
      [](input const& v) {
        input in = v;
        in.k = weight(0);
        const auto first = hls::calculate_new_p(in);
        in.k = weight(16);
        const auto second = hls::calculate_new_p(in);
        for (int i = 0; i < 3; ++i)
          if (raw(first.p[i]) != raw(in.p1[i]) || raw(second.p[i]) != raw(in.p2[i])) return testing::AssertionFailure() << "not the end";
        return testing::AssertionSuccess();
      },
      10000);
}

TEST(calculate_new_p, the_middle_of_neighbours_rounds_up) {
  const auto middle = [](std::int64_t a, std::int64_t b) {
    return raw(hls::calculate_new_p({{hls::from_raw<formats::position>(a)}, {hls::from_raw<formats::position>(b)}, weight(8)}).p[0]);
  };
  EXPECT_EQ(middle(0, 1), 1);
  EXPECT_EQ(middle(1, 0), 1);
  EXPECT_EQ(middle(-1, 0), 0);
  EXPECT_EQ(middle(-2, -1), -1);
  EXPECT_EQ(middle(-3, 3), 0);
}

}  // namespace
}  // namespace relievo::test
