// highlight_test: hls equals golden; symmetric in the ends; one LSB of the product either side of the threshold, for each of the three.
#include "hls/edge/highlight_test.hpp"

#include <gtest/gtest.h>

#include "golden/edge/highlight_test.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::highlight_test_in, hls::highlight_test_regs>;

testing::AssertionResult agrees(vector const& v) {
  const auto out = hls::highlight_test(v.in, v.regs);
  const auto result = equal_words(out, golden::highlight_test<golden::rounded>(as_golden<golden::highlight_test_in>(v.in),
                                                                               as_golden<golden::highlight_test_regs>(v.regs)));
  if (!result) return result;
  vector back = v;
  for (int i = 0; i < 3; ++i) {
    back.in.n1[i] = v.in.n2[i];
    back.in.n2[i] = v.in.n1[i];
  }
  return hls::highlight_test(back.in, v.regs).ht == out.ht ? result : testing::AssertionFailure() << "the ends are not alike";
}

TEST(highlight_test, hls_equals_golden_from_either_end) { for_vectors<vector>(any_word(), agrees); }

// The threshold is the word at or just below one of the products, so the comparison is decided by its last bits.
TEST(highlight_test, hls_equals_golden_at_the_threshold) {
  std::uint64_t positive = 0, seen = 0;
  for_vectors<vector>(
      [](vector& v, generator& g) {
        unit_vector(v.in.n1, g);
        unit_vector(v.regs.half_vector, g);
        for (int i = 0; i < 3; ++i) {
          near(v.in.n2[i], v.in.n1[i], 2, g);
          near(v.in.n12[i], v.in.n1[i], 2, g);
        }
        std::int64_t product = 0;
        for (int i = 0; i < 3; ++i) product += raw(v.in.n12[i]) * raw(v.regs.half_vector[i]);
        const std::int64_t word = (product >> 14) + g.between(-1, 1);
        v.regs.threshold = hls::from_raw<formats::unit>(word > 32767 ? 32767 : word < -32768 ? -32768 : word);
      },
      [&](vector const& v) {
        ++seen;
        positive += hls::highlight_test(v.in, v.regs).ht ? 1 : 0;
        return agrees(v);
      });
  EXPECT_GT(positive, seen / 8);
  EXPECT_LT(positive, seen * 19 / 20);
}

TEST(highlight_test, each_of_the_three_normals_alone_decides) {
  for (int which = 0; which < 3; ++which) {
    vector v{};
    v.regs.half_vector[1] = hls::from_raw<formats::unit>(16384);
    v.regs.threshold = hls::from_raw<formats::unit>(8000);
    auto& n = which == 0 ? v.in.n1 : which == 1 ? v.in.n2 : v.in.n12;
    n[1] = hls::from_raw<formats::unit>(8000);
    EXPECT_FALSE(hls::highlight_test(v.in, v.regs).ht) << "equal to the threshold is not above it";
    n[1] = hls::from_raw<formats::unit>(8001);
    EXPECT_TRUE(hls::highlight_test(v.in, v.regs).ht) << which;
    // One LSB of the product, 2^-28, is enough.
    n[1] = hls::from_raw<formats::unit>(8000);
    v.regs.half_vector[0] = hls::from_raw<formats::unit>(1);
    n[0] = hls::from_raw<formats::unit>(1);
    EXPECT_TRUE(hls::highlight_test(v.in, v.regs).ht) << which;
  }
}

}  // namespace
}  // namespace relievo::test
