// z_table: the logarithms are correctly rounded; hls equals golden; within its bound of kappa ln(1 + i/256); never falls.
#include "hls/sweep/z_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "golden/sweep/z_table.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

struct vector {
  hls::z_table_in in;
  RELIEVO_FIELDS(in)
};

hls::z_table_in entry(hls::fixed<formats::kappa> kappa, int i) { return {kappa, hls::from_raw<format<9, 9, false>>(i)}; }

// None is so near to half an LSB that the last bit would hang on long double, or on what the kernel's constants leave off.
TEST(z_table, logarithms_are_correctly_rounded) {
  for (int i = 0; i < hls::z_table_words; ++i) {
    const long double exact = std::ldexp(std::log1p(static_cast<long double>(i) / 256), 30);
    ASSERT_EQ(static_cast<long double>(hls::detail::logarithms.word[i]), std::floor(exact + 0.5L)) << i;
    ASSERT_GT(std::abs(exact - std::floor(exact) - 0.5L), std::ldexp(1.0L, -8)) << i;
  }
}

TEST(z_table, hls_equals_golden) {
  for_vectors<vector>(
      [](vector& v, generator& g) {
        if (raw(v.in.i) >= hls::z_table_words) v.in.i = entry(v.in.kappa, static_cast<int>(g.below(hls::z_table_words))).i;
      },
      [](vector const& v) { return equal_words(hls::z_table(v.in), golden::z_table(as_golden<golden::z_table_in>(v.in))); });
}

TEST(z_table, is_near_the_logarithm_and_never_falls) {
  generator g = next_generator();
  for (int round = 0; round < 200; ++round) {
    const auto kappa =
        hls::from_raw<formats::kappa>(round == 0 ? hls::fixed<formats::kappa>::max_raw : g.between(0, 0xffffffff) >> g.below(32));
    const long double k = std::ldexp(static_cast<long double>(raw(kappa)), -formats::kappa::fraction);
    std::int64_t last = -1;
    for (int i = 0; i < hls::z_table_words; ++i) {
      const std::int64_t z = raw(hls::z_table(entry(kappa, i)).z);
      const long double exact = std::ldexp(k * std::log1p(static_cast<long double>(i) / 256), formats::depth_cells::fraction);
      ASSERT_LE(std::abs(static_cast<long double>(z) - exact), 0.5L + std::ldexp(k, formats::depth_cells::fraction - 31) + 1e-6L) << i;
      ASSERT_GE(z, i == 0 ? 0 : last);
      last = z;
    }
    ASSERT_EQ(raw(hls::z_table(entry(kappa, 0)).z), 0);
  }
}

}  // namespace
}  // namespace relievo::test
