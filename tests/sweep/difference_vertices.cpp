// difference_vertices: hls equals golden; every quotient correctly rounded, decided in 128 bits; results below 2^45; none where |det| <= n;
// an edge's differences are the same from both of its triangles.
#include "hls/sweep/difference_vertices.hpp"

#include <gtest/gtest.h>

#include "golden/sweep/difference_vertices.hpp"
#include "tests/support/swept_data.hpp"

namespace relievo::test {
namespace {

__extension__ typedef __int128 int128;

// q = floor(numerator 2^16 / denominator + 1/2)
bool rounds(std::int64_t q, int128 numerator, std::int64_t denominator) {
  if (denominator < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  const int128 twice = numerator * (int128{2} << hls::guard_bits);
  return (2 * int128{q} - 1) * denominator <= twice && twice < (2 * int128{q} + 1) * denominator;
}
bool small(std::int64_t q) { return std::abs(q) < std::int64_t{1} << 45; }

testing::AssertionResult right(swept_triangle const& triangle) {
  hls::difference_vertices_in const& in = triangle.in;
  const auto out = hls::difference_vertices(in);
  const auto fails = [&](char const* what) {
    return testing::AssertionFailure() << what << ": " << text_of(triangle.p) << "\n" << describe(in);
  };
  for (std::size_t e = 0; e < 3; ++e) {
    const std::int64_t n = triangle.steps(e);
    const auto from = tb::raw_words(in.end[e][0]), to = tb::raw_words(in.end[e][1]), step = tb::raw_words(out.edge[e]);
    for (std::size_t i = 0; i < step.size(); ++i)
      if (n == 0 ? step[i] != 0 : !rounds(step[i], to[i] - from[i], n) || !small(step[i])) return fails("an edge");
  }
  const auto a = static_cast<std::size_t>(raw(in.plane.a)), b = static_cast<std::size_t>(raw(in.plane.b)),
             c = static_cast<std::size_t>(raw(in.plane.c));
  const auto s = static_cast<std::size_t>(raw(in.plane.s)), t = static_cast<std::size_t>(raw(in.plane.t));
  const auto d = [&](std::size_t to, std::size_t axis) { return std::int64_t{triangle.p[to][axis]} - triangle.p[a][axis]; };
  const std::int64_t det = d(b, s) * d(c, t) - d(c, s) * d(b, t), n = d(b, s);
  const auto va = tb::raw_words(in.corner[a]), vb = tb::raw_words(in.corner[b]), vc = tb::raw_words(in.corner[c]);
  const auto sweep = tb::raw_words(out.sweep), side = tb::raw_words(out.side);
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    if (std::abs(det) <= n) {
      if (sweep[i] != 0 || side[i] != 0) return fails("none is needed");
      continue;
    }
    const int128 ab = vb[i] - va[i], ac = vc[i] - va[i];
    if (!rounds(sweep[i], ab * d(c, t) - ac * d(b, t), det) || !small(sweep[i])) return fails("the sweep");
    if (!rounds(side[i], ac * d(b, s) - ab * d(c, s), det) || !small(side[i])) return fails("the side");
  }
  return equal_words(out, golden::difference_vertices(as_golden<golden::difference_vertices_in>(in)));
}

TEST(difference_vertices, hls_equals_golden_and_quotients_are_correctly_rounded) {
  generator g = next_generator();
  for (std::uint64_t round = 0; round < vector_count() / 10; ++round) {
    const int size = round % 4 == 0 ? 6 : round % 4 == 1 ? 200 : 16383;
    ASSERT_TRUE(right(draw_swept(g, round % 3 == 0 ? draw_sliver(g, size) : draw_triangle(g, size))));
  }
}

TEST(difference_vertices, every_triangle_of_a_grid) {
  generator g = next_generator();
  for (std::uint64_t number = 0; number < pairs_within(2); ++number) ASSERT_TRUE(right(draw_swept(g, pair_of(number, 2))));
}

// The largest differences over the smallest determinants: opposite ends of the formats, |det| just above n.
TEST(difference_vertices, the_ends_of_the_formats) {
  generator g = next_generator();
  std::array<hls::base_vertex, 2> end{};
  const auto fill = [](hls::base_vertex& v, bool top) {
    tb::detail::walk(v, [top](std::string const&, auto& x) {
      using word = std::remove_reference_t<decltype(x)>;
      x = word::from_raw(top ? word::max_raw : word::min_raw);
    });
  };
  fill(end[0], false);
  fill(end[1], true);
  const depth_word w = hls::from_raw<formats::depth>(1 << 20);
  std::uint64_t steep = 0;
  for (std::uint64_t round = 0; round < vector_count() / 200; ++round) {
    const grid_triangle p =
        round % 8 == 0 ? grid_triangle{{{-32767, -32767, 0}, {32767, 32767, 0}, {-32766, -32765, 1}}} : draw_sliver(g, 16383);
    for (unsigned ends = 0; ends < 8; ++ends) {
      const swept_triangle triangle(p, {end[ends & 1], end[ends >> 1 & 1], end[ends >> 2 & 1]}, {w, w, w});
      ASSERT_TRUE(right(triangle));
      const std::int64_t most = std::abs(raw(hls::difference_vertices(triangle.in).side.p[0]));
      steep += most >= std::int64_t{1} << 41 ? 1 : 0;
    }
  }
  EXPECT_GT(steep, 0U) << "no difference comes near its bound";
}

// Half an LSB over: only where 2^17 divides det. A negative quotient goes up too, whatever the sign of det.
TEST(difference_vertices, ties_go_up) {
  generator g = next_generator();
  std::uint64_t ties = 0;
  in_all_poses({{{0, 0, 0}, {512, 512, 0}, {1, 257, 0}}}, [&](grid_triangle const& p) {
    for (int round = 0; round < 4; ++round) {
      const swept_triangle triangle = draw_swept(g, p);
      ASSERT_TRUE(right(triangle));
      ASSERT_EQ(std::abs(raw(triangle.in.plane.det)), 1 << 17);
      const auto c = [&](hls::two_bits corner) { return raw(triangle.in.corner[raw(corner)].c); };
      // ds_AB is even, so the side's quotients have halves where dV_AB is odd.
      ties += static_cast<std::uint64_t>((c(triangle.in.plane.b) - c(triangle.in.plane.a)) & 1);
    }
  });
  EXPECT_GT(ties, 100U);
}

TEST(difference_vertices, neighbours_have_the_same_edge) {
  generator g = next_generator();
  for (std::uint64_t round = 0; round < vector_count() / 50; ++round) {
    const grid_triangle p = draw_triangle(g, round % 2 == 0 ? 8 : 16383);
    const swept_triangle one = draw_swept(g, p);
    // The other way round, with another third corner in front of it: another block of the triangle, the same of the edge.
    grid_triangle q = {p[1], p[0], draw_triangle(g, 20)[0]};
    const swept_triangle other(q, {one.vertex[1], one.vertex[0], draw_vertex(g)},
                               {one.w[1], one.w[0], hls::from_raw<formats::depth>(1 << 12)});
    if (one.steps(0) == 0) continue;
    ASSERT_TRUE(same_words(hls::difference_vertices(one.in).edge[0], hls::difference_vertices(other.in).edge[0])) << text_of(p);
  }
}

}  // namespace
}  // namespace relievo::test
