// grid_transform_golden: the table's words and the grid's against whole numbers of 128 bits, and against the logarithm: every octave of w
// and its borders, registers of any size, both ends of the grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "golden/sweep/grid_transform.hpp"
#include "golden/sweep/z_table.hpp"
#include "tests/support/swept_vertices.hpp"

namespace relievo::test {
namespace {

using namespace golden;
using golden::detail::int128;

std::int64_t floored(int128 x, int shift) { return static_cast<std::int64_t>(x >> shift); }
std::int64_t shifted(int128 x, int shift) { return floored(x + (static_cast<int128>(1) << (shift - 1)), shift); }

TEST(grid_transform_golden, the_logarithms_are_far_from_ties) {
  for (int i = 0; i < z_table_words; ++i) {
    const long double exact_word = std::ldexp(std::log(1 + i / 256.0L), 30);
    const std::int64_t given = word<logarithm>(rounded::at<logarithm>(std::log1p(i / 256.0)));
    ASSERT_EQ(given, static_cast<std::int64_t>(std::floor(exact_word + 0.5L))) << i;
    // A double's logarithm is right to 2^-22 of such a word.
    const long double from_tie = std::abs(exact_word - std::floor(exact_word) - 0.5L);
    ASSERT_GT(from_tie, std::ldexp(1.0L, -20)) << i;
  }
}

TEST(grid_transform_golden, the_table_is_rounded_once) {
  draw d(seed());
  for (std::uint64_t n = 0; n < rounds(1000); ++n) {
    const double kappa = n == 0 ? range_of<formats::kappa>::max : n == 1 ? 0 : rounded::at<formats::kappa>(std::exp2(d.real(-14, 18)));
    const std::vector<double> table = z_table_of(kappa);
    ASSERT_EQ(table.size(), 257U);
    ASSERT_EQ(table[0], 0);
    for (int i = 0; i < z_table_words; ++i) {
      const auto l = static_cast<int128>(std::floor(std::ldexp(std::log(1 + i / 256.0L), 30) + 0.5L));
      ASSERT_EQ(word<formats::depth_cells>(table[static_cast<std::size_t>(i)]), shifted(l * word<formats::kappa>(kappa), 30)) << i;
    }
  }
}

// Words of the table and the registers as they come, not only those of one kappa.
struct z_registers {
  grid_transform_regs regs;
  std::vector<double> table;
};
z_registers draw_registers(draw& d, bool any) {
  z_registers z;
  using range = range_of<formats::depth_cells>;
  const auto draw_word = [&d](double reach) { return rounded::at<formats::depth_cells>(d.real(-1, 1) * reach); };
  if (any) {
    const double reach = d.coin() ? -range::min : std::exp2(d.real(-10, 25));
    for (int i = 0; i < z_table_words; ++i) z.table.push_back(d.integer(0, 9) == 0 ? range::min : draw_word(reach));
    z.regs.octave = d.coin() ? range::min : draw_word(reach);
    z.regs.near_cells = d.coin() ? range::max : draw_word(reach);
  } else {
    z.table = z_table_of(rounded::at<formats::kappa>(std::exp2(d.real(0, 17))));
    z.regs.octave = z.table[256];
    z.regs.near_cells = depth_cells_of(d.word<formats::depth>(0.01, 10), z.regs.octave, z.table);
  }
  z.regs.cells_per_pixel = d.integer(0, 9) == 0 ? range_of<formats::cells>::max : d.word<formats::cells>(0, 1);
  return z;
}

void expect_grid(z_registers const& z, glm::dvec2 const& screen, std::int64_t w) {
  int e = 27;
  while (w >> e == 0) --e;
  // 27 bits behind the leading one: eight of i, nineteen of f.
  const std::int64_t below = (w << (27 - e)) - (std::int64_t{1} << 27), i = below >> 19, f = below & ((1 << 19) - 1);
  const auto cells = [](double x) { return static_cast<int128>(word<formats::depth_cells>(x)); };
  const auto t = [&](std::int64_t k) { return cells(z.table[static_cast<std::size_t>(k)]); };
  const int128 sum = (e * cells(z.regs.octave) + t(i)) * (1 << 19) + f * (t(i + 1) - t(i));
  const std::int64_t expected[3] = {
      shifted(static_cast<int128>(word<formats::screen>(screen.x)) * word<formats::cells>(z.regs.cells_per_pixel), 31),
      shifted(static_cast<int128>(word<formats::screen>(screen.y)) * word<formats::cells>(z.regs.cells_per_pixel), 31),
      shifted(sum - cells(z.regs.near_cells) * (1 << 19), 33)};
  const double w_value = static_cast<double>(w) * range_of<formats::depth>::lsb;
  const auto out = grid_transform({screen, w_value}, z.regs, z.table);
  bool saturated = false;
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(word<formats::grid>(out.p[k]), std::min<std::int64_t>(std::max<std::int64_t>(expected[k], -32767), 32767)) << k << " w " << w;
    saturated |= std::abs(expected[k]) > 32767;
  }
  ASSERT_EQ(out.saturated, saturated);
  const std::int64_t limit = std::int64_t{1} << 39;
  ASSERT_EQ(word<formats::depth_cells>(depth_cells_of(w_value, z.regs.octave, z.table)),
            std::min(std::max(shifted(sum, 19), -limit), limit - 1));
}

TEST(grid_transform_golden, the_grid_is_rounded_once) {
  draw d(seed());
  const auto draw_screen = [&d] {
    return rounded::at<formats::screen>(d.integer(0, 9) == 0 ? (d.coin() ? 8192 : -8192) : d.real(-8192, 8192));
  };
  for (std::uint64_t n = 0; n < rounds(400); ++n) {
    const z_registers z = draw_registers(d, n % 2 == 0);
    for (int k = 0; k < 28; ++k)
      for (int off = -2; off <= 2; ++off) {
        const std::int64_t w = (std::int64_t{1} << k) + off;
        if (w > 0 && w < std::int64_t{1} << 28) expect_grid(z, {draw_screen(), draw_screen()}, w);
      }
    for (int k = 0; k < 300 && !HasFailure(); ++k) {
      const std::int64_t w = std::max(1, (1 << 27 | d.integer(0, (1 << 27) - 1)) >> d.integer(0, 27));
      expect_grid(z, {draw_screen(), draw_screen()}, w);
    }
    if (HasFailure()) return;
  }
}

// What the grid stands on: z grows with w, over the borders of the table's intervals and octaves too, and is 0 at `near`.
TEST(grid_transform_golden, z_never_falls_as_w_grows) {
  draw d(seed());
  for (std::uint64_t n = 0; n < rounds(4000); ++n) {
    const z_registers z = draw_registers(d, false);
    const auto at = [&z](std::int64_t w) {
      return depth_cells_of(static_cast<double>(w) * range_of<formats::depth>::lsb, z.regs.octave, z.table);
    };
    for (int k = 0; k < 28; ++k)
      for (int i = 0; i < 256; ++i) {
        const std::int64_t w = (std::int64_t{256 + i} << k) >> 8;
        ASSERT_LE(at(std::max<std::int64_t>(w - 1, 1)), at(w)) << "w " << w;
        ASSERT_LE(at(w), at(w + 1)) << "w " << w;
      }
    const double near = d.word<formats::depth>(0.001, 100);
    grid_transform_regs regs = z.regs;
    regs.near_cells = depth_cells_of(near, regs.octave, z.table);
    ASSERT_EQ(grid_transform({{0, 0}, near}, regs, z.table).p.z, 0);
  }
}

}  // namespace
}  // namespace relievo::test
