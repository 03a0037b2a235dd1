// primary_edge: hls equals golden; theorem 1 by exhaustion; the longest, the first on ties.
//   Theorem 1 asks only for the order of the coordinates and of their differences: signs of linear forms in the two differences of a
//   triangle. Every such pattern that large triangles have is there among the differences in [-6, 6]^3, which are counted through.
#include "hls/sweep/primary_edge.hpp"

#include <gtest/gtest.h>

#include "golden/sweep/primary_edge.hpp"
#include "hls/sweep/main_direction.hpp"
#include "tests/support/grid_triangles.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using input = hls::primary_edge_in;

input edges_of(grid_triangle const& p) {
  input in;
  for (std::size_t i = 0; i < 3; ++i) {
    hls::main_direction_in ends;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      in.p[i][axis] = ends.p[0][axis] = hls::from_raw<formats::grid>(p[i][axis]);
      ends.p[1][axis] = hls::from_raw<formats::grid>(p[(i + 1) % 3][axis]);
    }
    const auto main = hls::main_direction(ends);
    in.axis[i] = main.axis;
    in.n[i] = main.n;
  }
  return in;
}

testing::AssertionResult agrees(input const& in) {
  return equal_words(hls::primary_edge(in), golden::primary_edge(as_golden<golden::primary_edge_in>(in)));
}

// Definition 2 and the choice among several, in plain integers.
bool is_primary(grid_triangle const& p, std::size_t edge) {
  grid_point const &p1 = p[edge], &p2 = p[(edge + 1) % 3], &p3 = p[(edge + 2) % 3];
  const std::size_t s = main_axis(p1, p2);
  return std::min(p1[s], p2[s]) <= p3[s] && p3[s] <= std::max(p1[s], p2[s]);
}
int steps(grid_triangle const& p, std::size_t edge) {
  grid_point const &p1 = p[edge], &p2 = p[(edge + 1) % 3];
  const std::size_t s = main_axis(p1, p2);
  return std::abs(p2[s] - p1[s]);
}

TEST(primary_edge, theorem_1_by_exhaustion) {
  constexpr int r = 6;
  for (std::uint64_t number = 0; number < pairs_within(r); ++number) {
    const grid_triangle p = pair_of(number, r);
    if (is_primary(p, 0) || is_primary(p, 1) || is_primary(p, 2)) continue;
    FAIL() << "no primary edge, triangle " << number;
  }
}

// Orders of the coordinates of the three corners in each axis, and of the three differences along each edge, as one number.
std::uint64_t pattern_of(grid_triangle const& p) {
  std::uint64_t pattern = 0;
  const auto order = [&pattern](int a, int b) { pattern = pattern * 3 + (a < b ? 0u : a == b ? 1u : 2u); };
  for (std::size_t i = 0; i < 3; ++i) {
    grid_point const &a = p[i], &b = p[(i + 1) % 3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      order(a[axis], b[axis]);
      order(std::abs(b[axis] - a[axis]), std::abs(b[(axis + 1) % 3] - a[(axis + 1) % 3]));
    }
  }
  return pattern;
}

// Drawn triangles, far larger than the grid, with as many ties as that of theorem 1 has: none has an order that is not on the grid.
TEST(primary_edge, the_grid_of_theorem_1_holds_every_order_and_tie) {
  constexpr int r = 6;
  std::vector<bool> seen(387420489);  // 3^18
  std::uint64_t patterns = 0;
  for (std::uint64_t number = 0; number < pairs_within(r); ++number) {
    auto there = seen[pattern_of(pair_of(number, r))];
    if (!there) ++patterns;
    there = true;
  }
  std::printf("%llu orders of coordinates and differences\n", static_cast<unsigned long long>(patterns));
  generator g("orders");
  for (std::uint64_t round = 0; round < vector_count(); ++round) {
    grid_triangle p{};
    const int unit = static_cast<int>(g.between(1, 1000)), most = g.chance(2) ? 4 : 30;
    for (std::size_t corner = 1; corner < 3; ++corner)
      for (int& x : p[corner]) x = unit * static_cast<int>(g.between(-most, most)) + (g.chance(4) ? static_cast<int>(g.between(-1, 1)) : 0);
    ASSERT_TRUE(seen[pattern_of(p)]) << "an order that the grid does not hold";
  }
}

TEST(primary_edge, hls_equals_golden) {
  for_vectors<input>([](input& in, generator& g) { in = edges_of(draw_triangle(g, g.chance(2) ? 6 : 16383)); }, agrees, vector_count() / 2);
}

TEST(primary_edge, hls_equals_golden_on_slivers) {
  for_vectors<input>([](input& in, generator& g) { in = edges_of(draw_sliver(g, g.chance(2) ? 6 : 16383)); }, agrees, vector_count() / 2);
}

TEST(primary_edge, the_longest_and_the_first_on_ties) {
  constexpr int r = 3;
  for (std::uint64_t number = 0; number < pairs_within(r); ++number) {
    const grid_triangle p = pair_of(number, r);
    std::size_t right = 3;
    for (std::size_t edge = 0; edge < 3; ++edge)
      if (is_primary(p, edge) && (right == 3 || steps(p, edge) > steps(p, right))) right = edge;
    ASSERT_EQ(static_cast<std::size_t>(raw(hls::primary_edge(edges_of(p)).edge)), right) << "triangle " << number;
  }
}

}  // namespace
}  // namespace relievo::test
