// grid_transform: hls equals golden, with any words in the table too; within its bound of equation (4); near is at 0; the order of depths
// is kept; what saturates.
#include "hls/sweep/grid_transform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "golden/sweep/grid_transform.hpp"
#include "hls/sweep/z_table.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::grid_transform_in, hls::grid_transform_regs>;
using depth_word = hls::fixed<formats::depth>;
depth_word depth(std::int64_t w) { return hls::from_raw<formats::depth>(w); }

struct table {
  std::array<std::int64_t, hls::z_table_words> words{};
  std::vector<double> values;

  template <class Word>
  explicit table(Word const& word) {
    for (int i = 0; i < hls::z_table_words; ++i) {
      words[static_cast<std::size_t>(i)] = word(i);
      values.push_back(std::ldexp(static_cast<double>(word(i)), -formats::depth_cells::fraction));
    }
  }
  hls::z_memory memory() const { return {words.data()}; }
};

table table_of(hls::fixed<formats::kappa> kappa) {
  return table([&](int i) { return raw(hls::z_table({kappa, hls::from_raw<format<9, 9, false>>(i)}).z); });
}

// Real tables, and one of any words, the ends of the format next to each other.
std::vector<table> const& tables() {
  static const std::vector<table> all = [] {
    std::vector<table> list;
    generator g("z tables");
    std::vector<std::int64_t> any;
    for (int i = 0; i < hls::z_table_words; ++i) any.push_back(random_word<formats::depth_cells>(draw::mixed, g));
    list.emplace_back([&](int i) { return any[static_cast<std::size_t>(i)]; });
    for (const std::int64_t bits : {1, 14, 20, 25, 32})
      list.push_back(table_of(hls::from_raw<formats::kappa>((std::int64_t{1} << bits) - 1)));
    return list;
  }();
  return all;
}

void before_the_eye(vector& v, generator&) {
  if (raw(v.in.w) == 0) v.in.w = depth(1);
}

TEST(grid_transform, hls_equals_golden) {
  std::size_t turn = 0;
  for_vectors<vector>(before_the_eye, [&turn](vector const& v) {
    table const& z = tables()[turn++ % tables().size()];
    return equal_words(
        hls::grid_transform(v.in, v.regs, z.memory()),
        golden::grid_transform(as_golden<golden::grid_transform_in>(v.in), as_golden<golden::grid_transform_regs>(v.regs), z.values));
  });
}

TEST(grid_transform, depth_cells_of_equals_golden) {
  generator g = next_generator();
  for (std::uint64_t round = 0; round < vector_count() / 4; ++round) {
    table const& z = tables()[round % tables().size()];
    const depth_word w = depth(std::max<std::int64_t>(1, random_word<formats::depth>(static_cast<draw>(round % 4), g)));
    const auto octave = hls::from_raw<formats::depth_cells>(random_word<formats::depth_cells>(draw::mixed, g));
    const double right = golden::depth_cells_of(std::ldexp(static_cast<double>(raw(w)), -formats::depth::fraction),
                                                std::ldexp(static_cast<double>(raw(octave)), -formats::depth_cells::fraction), z.values);
    ASSERT_EQ(static_cast<double>(raw(hls::depth_cells_of(w, octave, z.memory()))), std::ldexp(right, formats::depth_cells::fraction))
        << raw(w) << " " << raw(octave);
  }
}

// A camera's words: g, alpha, H, near.
struct camera {
  long double kappa;
  table z;
  hls::grid_transform_regs regs;

  camera(int cell, int degrees, int lines, depth_word near)
      : kappa(1 / std::log1p(2 * cell * std::tan(static_cast<long double>(degrees) * 3.14159265358979323846L / 360) / lines)),
        z(table_of(word())) {
    regs.cells_per_pixel = hls::from_raw<formats::cells>(std::llround(std::ldexp(1.0, formats::cells::fraction) / cell));
    regs.octave = hls::from_raw<formats::depth_cells>(z.words[hls::z_table_words - 1]);
    regs.near_cells = hls::depth_cells_of(near, regs.octave, z.memory());
  }
  hls::fixed<formats::kappa> word() const {
    return hls::from_raw<formats::kappa>(std::llround(std::ldexp(kappa, formats::kappa::fraction)));
  }
  hls::grid_transform_out at(depth_word w) const { return hls::grid_transform({{}, w}, regs, z.memory()); }
};

// docs/error_budget.md, "The grid in z".
long double bound(camera const& c, long double ratio) {
  const long double octaves = std::log2(ratio) + 1, lsb = std::ldexp(1.0L, -formats::depth_cells::fraction);
  const long double words = (octaves + 3) * (lsb / 2 + std::ldexp(c.kappa, -31)), interpolation = std::ldexp(c.kappa, -19);
  return 0.5L + interpolation + words + std::log(ratio) * lsb / 2;
}

TEST(grid_transform, is_near_equation_4) {
  generator g = next_generator();
  long double most = 0, nearest_to_bound = 0;
  std::uint64_t seen = 0;
  for (const int cell : {1, 5, 20, 45})
    for (const int degrees : {5, 30, 60, 90, 120, 170})
      for (const int lines : {1, 64, 300, 1080, 8191})
        for (const std::int64_t near : {4096, 5000, 1 << 14, 999999, 1 << 20}) {
          const camera c(cell, degrees, lines, depth(near));
          ASSERT_EQ(raw(c.at(depth(near)).p[2]), 0);
          for (std::uint64_t round = 0; round < vector_count() / 10000 + 2; ++round) {
            const std::int64_t far = std::min(near * 10000, hls::fixed<formats::depth>::max_raw);
            const auto w =
                static_cast<std::int64_t>(static_cast<double>(near) * std::pow(static_cast<double>(far) / static_cast<double>(near),
                                                                               static_cast<double>(g.below(1 << 20)) / (1 << 20)));
            const long double ratio = static_cast<long double>(w) / static_cast<long double>(near), exact = c.kappa * std::log(ratio);
            const auto out = c.at(depth(w));
            if (exact > 32767.49L) {
              ASSERT_TRUE(exact < 32768 || (out.saturated && raw(out.p[2]) == 32767));
              continue;
            }
            const long double error = std::abs(static_cast<long double>(raw(out.p[2])) - exact);
            ASSERT_LE(error, bound(c, ratio)) << cell << " " << degrees << " " << lines << " " << near << " " << w;
            most = std::max(most, error);
            nearest_to_bound = std::max(nearest_to_bound, (error - 0.5L) / (bound(c, ratio) - 0.5L));
            ++seen;
          }
        }
  std::printf("z: at most %.4Lf cells from equation (4), beyond the half %.0Lf %% of the bound; %llu depths\n", most,
              100 * nearest_to_bound, static_cast<unsigned long long>(seen));
  EXPECT_GT(nearest_to_bound, 0.25L) << "the depths do not come near the bound";
}

// readings.md: near 1, far 100, 90 degrees, 300 lines is about 693 cells.
TEST(grid_transform, the_example_of_the_paper) { EXPECT_EQ(raw(camera(1, 90, 300, depth(1 << 20)).at(depth(100 << 20)).p[2]), 693); }

TEST(grid_transform, farther_is_never_nearer) {
  generator g = next_generator();
  for (const int cell : {1, 45})
    for (const int degrees : {5, 60, 170}) {
      const camera c(cell, degrees, 1080, depth(4096));
      for (std::uint64_t round = 0; round < vector_count() / 100; ++round) {
        const std::int64_t w = round % 3 == 0 ? (std::int64_t{1} << g.between(1, 27)) - 1
                                              : std::max<std::int64_t>(1, random_word<formats::depth>(draw::magnitude, g));
        if (w == hls::fixed<formats::depth>::max_raw) continue;
        ASSERT_LE(raw(c.at(depth(w)).p[2]), raw(c.at(depth(w + 1)).p[2])) << w;
        ASSERT_LE(raw(hls::depth_cells_of(depth(w), c.regs.octave, c.z.memory())),
                  raw(hls::depth_cells_of(depth(w + 1), c.regs.octave, c.z.memory())))
            << w;
      }
    }
}

// A grid position by hand: screen times 1/g, halves up; the ends.
TEST(grid_transform, positions_are_rounded_half_up_and_held_at_their_ends) {
  const table flat([](int) { return 0; });
  hls::grid_transform_regs regs{};
  const auto at = [&](std::int64_t x, std::int64_t cells, std::int64_t near) {
    regs.cells_per_pixel = hls::from_raw<formats::cells>(cells);
    regs.near_cells = hls::from_raw<formats::depth_cells>(near);
    return hls::grid_transform({{hls::from_raw<formats::screen>(x), hls::from_raw<formats::screen>(-x)}, depth(1)}, regs, flat.memory());
  };
  constexpr std::int64_t one = std::int64_t{1} << formats::cells::fraction, cell = std::int64_t{1} << formats::depth_cells::fraction;
  EXPECT_EQ(raw(at(128, one, 0).p[0]), 1);
  EXPECT_EQ(raw(at(128, one, 0).p[1]), 0);
  EXPECT_EQ(raw(at(127, one, 0).p[0]), 0);
  EXPECT_EQ(raw(at(5 * 640, one / 5, 0).p[0]), 2) << "1/5 is held below itself";
  EXPECT_EQ(raw(at(0, one, cell / 2).p[2]), 0) << "minus a half goes up";
  EXPECT_EQ(raw(at(0, one, cell / 2 + 1).p[2]), -1);
  for (const std::int64_t z : {-32767, 32767}) {
    EXPECT_FALSE(at(0, one, -z * cell).saturated);
    EXPECT_EQ(raw(at(0, one, -z * cell).p[2]), z);
  }
  EXPECT_TRUE(at(0, one, 32768 * cell).saturated) << "-32768 is no position";
  EXPECT_EQ(raw(at(0, one, 32768 * cell).p[2]), -32767);
  EXPECT_TRUE(at(0, one, -32768 * cell).saturated);
  EXPECT_EQ(raw(at(0, one, -32768 * cell).p[2]), 32767);
}

}  // namespace
}  // namespace relievo::test
