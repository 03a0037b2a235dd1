// main_direction: hls equals golden; the ends are alike; ties x over y over z, on every difference of a grid.
#include "hls/sweep/main_direction.hpp"

#include <gtest/gtest.h>

#include "golden/sweep/main_direction.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using input = hls::main_direction_in;

testing::AssertionResult agrees(input const& in) {
  const auto out = hls::main_direction(in);
  const auto result = equal_words(out, golden::main_direction(as_golden<golden::main_direction_in>(in)));
  if (!result) return result;
  input back;
  for (int axis = 0; axis < 3; ++axis) {
    back.p[0][axis] = in.p[1][axis];
    back.p[1][axis] = in.p[0][axis];
  }
  return same_words(hls::main_direction(back), out);
}

TEST(main_direction, hls_equals_golden) { for_vectors<input>(any_word(), agrees, vector_count() / 2); }

TEST(main_direction, hls_equals_golden_near_ties) {
  for_vectors<input>(
      [](input& in, generator& g) {
        const std::int64_t n = g.between(0, g.chance(2) ? 20 : 32767);
        for (int axis = 0; axis < 3; ++axis) {
          const std::int64_t from = g.between(-32767, 32767 - n), d = std::max<std::int64_t>(0, n - g.between(0, 2));
          const bool rising = g.chance(2);
          in.p[rising ? 0 : 1][axis] = hls::from_raw<formats::grid>(from);
          in.p[rising ? 1 : 0][axis] = hls::from_raw<formats::grid>(from + d);
        }
      },
      agrees, vector_count() / 2);
}

TEST(main_direction, every_difference_of_a_grid) {
  for (int number = 0; number < 13 * 13 * 13; ++number) {
    const int d[3] = {number % 13 - 6, number / 13 % 13 - 6, number / 169 - 6};
    input in{};
    for (int axis = 0; axis < 3; ++axis) in.p[1][axis] = hls::from_raw<formats::grid>(d[axis]);
    const auto out = hls::main_direction(in);
    const int x = std::abs(d[0]), y = std::abs(d[1]), z = std::abs(d[2]);
    ASSERT_EQ(raw(out.axis), x >= y && x >= z ? 0 : y >= z ? 1 : 2) << describe(in);
    ASSERT_EQ(raw(out.n), std::max({x, y, z})) << describe(in);
    ASSERT_TRUE(agrees(in)) << describe(in);
  }
}

TEST(main_direction, the_longest_edge_of_the_format) {
  input in{};
  in.p[0][1] = hls::from_raw<formats::grid>(-32768);
  in.p[1][1] = hls::from_raw<formats::grid>(32767);
  EXPECT_EQ(raw(hls::main_direction(in).axis), 1);
  EXPECT_EQ(raw(hls::main_direction(in).n), 65535);
}

}  // namespace
}  // namespace relievo::test
