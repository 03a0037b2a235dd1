// grid_transform_ideal: z against (4) in long double, for far / near up to 10^4, viewports up to 8191 lines, angles from 5 to 170 degrees
// and cells of 1, 5, 20 and 45 pixels, within the bound of docs/error_budget.md, "The grid in z"; and the paper's own Figure 7.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "golden/sweep/grid_transform.hpp"
#include "golden/sweep/z_table.hpp"
#include "tests/support/draw.hpp"
#include "tests/support/settings.hpp"

namespace relievo::test {
namespace {

using namespace golden;

long double kappa_of(int cell, long double degrees, int lines) {
  const long double half = degrees * 3.14159265358979323846L / 360;
  return 1 / std::log1p(cell * 2 * std::tan(half) / lines);
}

int octave_of(double w) { return detail::place_in_octave(w).e; }

// In cells, without the last rounding.
long double bound(long double kappa, double w, double near) {
  const int octaves = std::abs(octave_of(w) - octave_of(near));
  return kappa * 0x1p-19L + kappa * (octaves + 2) * 0x1p-31L + (octaves + 3 + std::abs(std::log(w / near))) * 0x1p-15L;
}

struct z_grid {
  long double kappa;
  std::vector<double> table;
  grid_transform_regs regs;

  z_grid(long double k, double near) : kappa(k), table(z_table_of(rounded::at<formats::kappa>(static_cast<double>(k)))) {
    regs.octave = table[256];
    regs.near_cells = depth_cells_of(near, regs.octave, table);
  }
};

TEST(grid_transform_ideal, z_is_within_its_bound_of_the_paper) {
  draw d(seed());
  constexpr int cells[4] = {1, 5, 20, 45};
  long double most = 0, most_cells = 0, saturated = 0, tried = 0;
  for (std::uint64_t n = 0; n < vector_count() / 500 + 100; ++n) {
    const int lines = n == 0 ? 8191 : static_cast<int>(std::exp2(d.real(5, 13)));
    const double degrees = n == 0 ? 5 : d.coin() ? d.real(5, 170) : std::exp2(d.real(std::log2(5), std::log2(170)));
    const double far_over_near = std::exp2(d.real(0.1, std::log2(1e4)));
    const double near = rounded::at<formats::depth>(std::exp2(d.real(-8, 8 - std::log2(far_over_near))));
    const z_grid z(kappa_of(n == 0 ? 1 : cells[d.integer(0, 3)], degrees, lines), near);
    for (int k = 0; k < 300; ++k) {
      const double reach = k < 20 ? 1 + std::exp2(d.real(-20, -4)) : std::exp2(d.real(0, std::log2(far_over_near)));
      const double w = rounded::at<formats::depth>(near * reach);
      const long double right = z.kappa * std::log(static_cast<long double>(w) / near), allowed = bound(z.kappa, w, near);
      const long double error = std::abs(depth_cells_of(w, z.regs.octave, z.table) - z.regs.near_cells - right);
      most = std::max(most, error / (allowed + 0x1p-15L));
      most_cells = std::max(most_cells, error);
      // depth_cells_of has a rounding of its own, which the grid's z has not.
      ASSERT_LE(error, allowed + 0x1p-15L) << "kappa " << static_cast<double>(z.kappa) << " near " << near << " w " << w;
      const auto out = grid_transform({{0, 0}, w}, z.regs, z.table);
      ++tried;
      if (out.saturated) {
        ++saturated;
        ASSERT_EQ(out.p.z, 32767);
        ASSERT_GT(right + allowed + 0.5L, 32767);
      } else {
        ASSERT_LE(std::abs(out.p.z - right), allowed + 0.5L);
      }
    }
  }
  std::printf("error of z up to %.3f cells before it is rounded, %.3f of its bound; %.1f %% beyond the grid\n",
              static_cast<double>(most_cells), static_cast<double>(most), static_cast<double>(100 * saturated / tried));
  EXPECT_GT(most, 0.8) << "the vectors do not come near the bound";
  EXPECT_LT(saturated, tried / 2);
}

// Figure 7: near 1, far 100, 90 degrees, 300 lines.
TEST(grid_transform_ideal, the_example_of_the_paper) {
  const z_grid z(kappa_of(1, 90, 300), 1);
  EXPECT_EQ(grid_transform({{0, 0}, 1}, z.regs, z.table).p.z, 0);
  EXPECT_EQ(grid_transform({{0, 0}, 100}, z.regs, z.table).p.z, 693);
  // A voxel is as deep as it is wide: one step of z is one pixel at that depth.
  for (int step = 1; step <= 693; ++step) {
    const double w = std::pow(1 + 2.0 / 300, step);
    EXPECT_EQ(grid_transform({{0, 0}, rounded::at<formats::depth>(w)}, z.regs, z.table).p.z, step);
  }
}

// The ideal has the table's chords, and nothing else beside the logarithm.
TEST(grid_transform_ideal, the_ideal_lies_on_the_chords) {
  draw d(seed());
  for (int n = 0; n < 1000; ++n) {
    const double kappa = d.real(1, 9e4), w = d.real(0.01, 250), near = d.real(0.01, 2);
    const std::vector<double> table = z_table_of<exact>(kappa);
    grid_transform_regs regs;
    regs.octave = table[256];
    regs.near_cells = depth_cells_of<exact>(near, regs.octave, table);
    const double z = grid_transform<exact>({{0, 0}, w}, regs, table).p.z;
    ASSERT_NEAR(z, kappa * std::log(w / near), kappa * std::ldexp(1, -19) + kappa * 1e-12);
  }
}

}  // namespace
}  // namespace relievo::test
