// vertex_data_neighbours: what makes neighbours agree, in golden alone: an edge has one set of words in all orders of its triangles'
// corners, the inner line the same from both sides, and a vertex of the grid lies between the corners.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "tests/support/swept_vertices.hpp"

namespace relievo::test {
namespace {

using namespace golden;

template <class Record>
std::vector<double> numbers_of(Record const& r) {
  std::vector<double> list;
  each_attribute([&list](auto, double const& x) { list.push_back(x); }, r);
  return list;
}

// Two triangles with one edge, in all orders of their corners; what the others do is no concern of the edge.
TEST(vertex_data_neighbours, an_edge_has_the_same_words_in_both_triangles) {
  draw d(seed());
  generator g("neighbours");
  std::uint64_t compared = 0;
  for (std::uint64_t i = 0; i < rounds(1000) && !HasFailure(); ++i) {
    const base_triangle one = draw_any(d, g);
    base_triangle other = draw_any(d, g);
    const auto common = [&](int corner, int from) {
      other.p[corner] = one.p[from];
      other.vertex[corner] = one.vertex[from];
      other.w[corner] = one.w[from];
    };
    const swept_vertices<rounded> first(one);
    for (int e = 0; e < 3; ++e) {
      const int next = (e + 1) % 3;
      for (int corner = 0; corner < 3; ++corner)
        for (int turn = 1; turn < 3; ++turn) {
          const int to = (corner + turn) % 3, edge = turn == 1 ? corner : to;
          common(corner, e);
          common(to, next);
          other.p[3 - corner - to] = one.p[e] + glm::dvec3(d.integer(-40, 40), d.integer(-40, 40), d.integer(-40, 40));
          const swept_vertices<rounded> second(other);
          ASSERT_EQ(second.steps_of(edge), first.steps_of(e));
          if (first.steps_of(e) < 2) continue;
          const int last = static_cast<int>(first.steps_of(e)) - 1;
          for (const int place : {1, last, d.integer(1, last)}) {
            const auto a = first.corrected({kind_edge, e, static_cast<double>(place), 0, 0});
            const auto b = second.corrected({kind_edge, edge, static_cast<double>(place), 0, 0});
            ASSERT_EQ(numbers_of(a), numbers_of(b));
            ASSERT_EQ(a.w_correction, b.w_correction);
            ASSERT_EQ(a.shift, b.shift);
            ++compared;
          }
        }
    }
  }
  EXPECT_GT(compared, rounds(1000));
}

// As the walks go: from A and from B, a step at a time, modulo 2^48. Both come to the words that the name has, B's walk backward.
TEST(vertex_data_neighbours, the_inner_line_has_the_same_words_from_both_sides) {
  draw d(seed());
  generator g("line");
  std::uint64_t compared = 0;
  for (std::uint64_t i = 0; i < rounds(2000) && !HasFailure(); ++i) {
    const base_triangle triangle = draw_base_triangle(d, draw_triangle(g, 60), 1e4);
    const swept_vertices<rounded> swept(triangle);
    interpolated_vertex_in const& in = swept.setup();
    if (std::abs(in.plane.det) <= swept.n()) continue;
    const int s = in.plane.s, t = in.plane.t;
    glm::dvec3 const &a = in.p[in.plane.a], &b = in.p[in.plane.b], &c = in.p[in.plane.c];
    const double foot = std::floor(a[t] + (b[t] - a[t]) * (c[s] - a[s]) / swept.n() + 0.5);
    for (double row = foot; row != c[t]; row += foot < c[t] ? 1 : -1) {
      const vertex_steps v = swept.at({kind_grid, 0, 0, c[s], row});
      each_component(
          [&](auto f, double const& start, double const& sweep, double const& side, double const& place) {
            using F = decltype(f);
            const auto bits = [](std::int64_t x) { return static_cast<std::uint64_t>(x); };
            const std::uint64_t along = bits(word<typename F::step>(sweep)), across = bits(word<typename F::step>(side));
            const std::uint64_t origin = bits(word<typename F::interp>(start)) << guard_bits;
            constexpr std::uint64_t low = (std::uint64_t{1} << 48) - 1;
            std::uint64_t from_a = origin;
            for (double k = a[s]; k < c[s]; ++k) from_a = (from_a + along) & low;
            std::uint64_t from_b =
                origin + bits(static_cast<std::int64_t>(b[s] - a[s])) * along + bits(static_cast<std::int64_t>(b[t] - a[t])) * across;
            for (double k = b[s]; k > c[s]; --k) from_b = (from_b - along) & low;
            const auto climb = [&](std::uint64_t x, double from) {
              for (; from < row; ++from) x += across;
              for (; from > row; --from) x -= across;
              return x & low;
            };
            const std::uint64_t named = bits(word<typename F::step>(place)) & low;
            ASSERT_EQ(climb(from_a, a[t]), named);
            ASSERT_EQ(climb(from_b, b[t]), named);
            ++compared;
          },
          in.corner[in.plane.a], in.difference.sweep, in.difference.side, v);
    }
  }
  EXPECT_GT(compared, rounds(2000));
}

// Vertices of the grid are within the triangle, where the data are between those of the corners; with |det| <= n there are none.
TEST(vertex_data_neighbours, vertices_of_the_grid_lie_within_the_triangle) {
  generator g("hull");
  draw d(seed());
  std::uint64_t within = 0;
  for (std::uint64_t i = 0; i < rounds(200) && !HasFailure(); ++i) {
    const grid_triangle grid = i % 4 == 0 ? draw_sliver(g, 200) : i % 64 == 1 ? draw_triangle(g, 100) : draw_triangle(g, 12);
    const base_triangle triangle = draw_base_triangle(d, grid, 1e4);
    const swept_vertices<rounded> swept(triangle);
    for (primitive const& q : sweep_line({{triangle.p[0], triangle.p[1], triangle.p[2]}}))
      for (int k = 0; k < (q.quad ? 4 : 3); ++k) {
        if (q.v[k].kind != kind_grid) continue;
        ASSERT_GT(std::abs(swept.plane().det), swept.n());
        long double b[3];
        swept.weights(q.v[k], b);
        ASSERT_TRUE(b[0] >= 0 && b[1] >= 0 && b[2] >= 0) << text_of(grid);
        ASSERT_GT(swept.at(q.v[k]).c, 0);
        ++within;
      }
  }
  EXPECT_GT(within, rounds(200));
}

}  // namespace
}  // namespace relievo::test
