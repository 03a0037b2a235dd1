// primary_edge: hls equals golden; theorem 1 by exhaustion; the longest, the first on ties.
//   Theorem 1 asks only for the order of the corners along each axis and of the differences along each edge. Every such pattern, ties
//   included, that a triangle can have is there among the differences in [-11, 11]^3, which are counted through.
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

// Orders of the corners along each axis, and of the differences along each edge, as one number.
std::size_t pattern_of(grid_triangle const& p) {
  std::size_t pattern = 0;
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
constexpr std::size_t patterns = 387420489;  // 3^18

// All triangles with differences in [-r, r]^3, up to mirror images: p1 - p0 in [0, r]^3.
template <class Call>
void for_pairs_up_to_mirrors(int r, Call call) {
  grid_triangle p{};
  grid_point &d = p[1], &e = p[2];
  for (d[0] = 0; d[0] <= r; ++d[0])
    for (d[1] = 0; d[1] <= r; ++d[1])
      for (d[2] = 0; d[2] <= r; ++d[2])
        for (e[0] = -r; e[0] <= r; ++e[0])
          for (e[1] = -r; e[1] <= r; ++e[1])
            for (e[2] = -r; e[2] <= r; ++e[2]) call(p);
}

// Few vectors, of a mutant's run, are few triangles here too.
int grid_of_theorem_1() { return vector_count() < 100000 ? 5 : 11; }

TEST(primary_edge, theorem_1_by_exhaustion) {
  std::uint64_t without = 0;
  for_pairs_up_to_mirrors(grid_of_theorem_1(), [&](grid_triangle const& p) {
    if (is_primary(p, 0) || is_primary(p, 1) || is_primary(p, 2)) return;
    if (without++ == 0) ADD_FAILURE() << "no primary edge: " << text_of(p);
  });
  EXPECT_EQ(without, 0U);
}

// Beyond 10 no larger grid has another pattern (counted up to 15), nor have drawn triangles, with as many ties as they may have.
TEST(primary_edge, the_grid_of_theorem_1_holds_every_order_and_tie) {
  const int r = grid_of_theorem_1();
  std::vector<bool> seen(patterns);
  std::uint64_t count = 0, smaller = 0;
  for_pairs_up_to_mirrors(r, [&](grid_triangle const& p) {
    auto there = seen[pattern_of(p)];
    if (!there) ++count;
    there = true;
  });
  std::printf("%llu patterns of order\n", static_cast<unsigned long long>(count));
  if (r < 11) return;
  EXPECT_EQ(count, 43940U);
  generator g("orders");
  for (std::uint64_t round = 0; round < vector_count(); ++round) {
    const int unit = static_cast<int>(g.between(1, 1000)), most = g.chance(2) ? 4 : 30;
    const auto draw = [&](int least) {
      return std::max(unit * static_cast<int>(g.between(-most, most)) + (g.chance(4) ? static_cast<int>(g.between(-1, 1)) : 0), least);
    };
    const grid_triangle p = {{{0, 0, 0}, {draw(0), draw(0), draw(0)}, {draw(-40000), draw(-40000), draw(-40000)}}};
    ASSERT_TRUE(seen[pattern_of(p)]) << "an order that the grid does not hold: " << text_of(p);
    smaller += std::max({p[1][0], p[1][1], p[1][2]}) <= r ? 1 : 0;
  }
  EXPECT_LT(smaller, vector_count() / 4) << "they are not drawn beyond the grid";
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
