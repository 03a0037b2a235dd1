// tex_coord_test: hls equals golden; symmetric in the ends; every place of a 20-bit grid; both coordinates count.
#include "hls/edge/tex_coord_test.hpp"

#include <gtest/gtest.h>

#include "golden/edge/tex_coord_test.hpp"
#include "hls/edge/calculate_new_u.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using input = hls::tex_coord_test_in;

testing::AssertionResult agrees(input const& in) {
  const auto out = hls::tex_coord_test(in);
  const auto result = equal_words(out, golden::tex_coord_test<golden::rounded>(as_golden<golden::tex_coord_test_in>(in)));
  if (!result) return result;
  input back = in;
  for (int i = 0; i < 2; ++i) {
    back.u1[i] = in.u2[i];
    back.u2[i] = in.u1[i];
  }
  if (hls::tex_coord_test(back).ct != out.ct) return testing::AssertionFailure() << "the ends are not alike";
  const auto same_texel = [&](hls::fixed<formats::coordinate> const(&u)[2]) {
    return raw(u[0]) / 2048 == raw(in.u12[0]) / 2048 && raw(u[1]) / 2048 == raw(in.u12[1]) / 2048;
  };
  return out.ct == !(same_texel(in.u1) || same_texel(in.u2)) ? result : testing::AssertionFailure() << "not what the texels say";
}

void at_midpoint(input& in, generator& g) {
  for (int i = 0; i < 2; ++i) near(in.u2[i], in.u1[i], g.chance(2) ? 3000 : 6000, g);
  const auto middle = hls::calculate_new_u({{in.u1[0], in.u1[1]}, {in.u2[0], in.u2[1]}, hls::from_raw<formats::weight>(8)});
  for (int i = 0; i < 2; ++i) in.u12[i] = middle.u[i];
}

TEST(tex_coord_test, hls_equals_golden_from_either_end) { for_vectors<input>(any_word(), agrees); }

TEST(tex_coord_test, hls_equals_golden_at_midpoints) {
  std::uint64_t positive = 0, seen = 0;
  for_vectors<input>(at_midpoint, [&](input const& in) {
    ++seen;
    positive += hls::tex_coord_test(in).ct ? 1 : 0;
    return agrees(in);
  });
  EXPECT_GT(positive, seen / 20);
  EXPECT_LT(positive, seen * 19 / 20);
}

// Each of the two axes with both ends on a grid of 32 places over four texels: 2^20 edges, at their midpoints.
TEST(tex_coord_test, every_edge_of_a_grid) {
  for (std::int64_t word = 0; word < (1 << 20); ++word) {
    input in{};
    for (int i = 0; i < 2; ++i) {
      in.u1[i] = hls::from_raw<formats::coordinate>((word >> (5 * i) & 31) * 256 + (i == 0 ? 0 : 255));
      in.u2[i] = hls::from_raw<formats::coordinate>((word >> (10 + 5 * i) & 31) * 256 + (i == 0 ? 255 : 0));
      in.u12[i] = hls::from_raw<formats::coordinate>((raw(in.u1[i]) + raw(in.u2[i]) + 1) / 2);
    }
    ASSERT_TRUE(agrees(in)) << describe(in);
  }
}

TEST(tex_coord_test, a_texel_of_its_own_in_one_axis_is_enough) {
  input in{};
  in.u1[0] = hls::from_raw<formats::coordinate>(2047);
  in.u12[0] = hls::from_raw<formats::coordinate>(2048);
  in.u2[0] = hls::from_raw<formats::coordinate>(4096);
  EXPECT_TRUE(hls::tex_coord_test(in).ct);
  in.u2[0] = hls::from_raw<formats::coordinate>(4095);
  EXPECT_FALSE(hls::tex_coord_test(in).ct);
  in.u2[1] = hls::from_raw<formats::coordinate>(2048);
  EXPECT_TRUE(hls::tex_coord_test(in).ct) << "the same column, another row";
}

}  // namespace
}  // namespace relievo::test
