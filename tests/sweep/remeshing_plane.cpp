// remeshing_plane: hls equals golden; A at the lower s, C above AB, the larger area and the earlier axis; det 0 means one line.
#include "hls/sweep/remeshing_plane.hpp"

#include <gtest/gtest.h>

#include "golden/sweep/remeshing_plane.hpp"
#include "tests/support/sweep_words.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using input = hls::remeshing_plane_in;

testing::AssertionResult agrees(input const& in) {
  return equal_words(hls::remeshing_plane(in), golden::remeshing_plane(as_golden<golden::remeshing_plane_in>(in)));
}
testing::AssertionResult right(input const& in) {
  const auto out = hls::remeshing_plane(in);
  const std::int64_t s = raw(out.s), t = raw(out.t), a = raw(out.a), b = raw(out.b), c = raw(out.c);
  const auto fails = [&] { return testing::AssertionFailure() << describe(in) << describe(out); };
  if (s == t || a == b || b == c || c == a) return fails() << "axes and corners are not distinct";
  if (raw(in.p[a][s]) > raw(in.p[b][s])) return fails() << "A is not at the lower s";
  const auto determinant = [&](std::int64_t axis) {
    const auto d = [&](std::int64_t to, std::int64_t k) { return raw(in.p[to][k]) - raw(in.p[a][k]); };
    return d(b, s) * d(c, axis) - d(b, axis) * d(c, s);
  };
  const std::int64_t other = 3 - s - t, det = determinant(t), det_other = determinant(other);
  if (raw(out.det) != det) return fails() << "det is not that of the corners";
  if (std::abs(det_other) > std::abs(det) || (std::abs(det_other) == std::abs(det) && other < t)) return fails() << "the wrong plane";
  return out.mirrored == (det < 0) ? testing::AssertionSuccess() : fails() << "C is not above AB";
}

// Every word: what is not asked for by an engine, a primary edge that is none, has an answer too.
TEST(remeshing_plane, hls_equals_golden_on_any_words) {
  for_vectors<input>(
      [](input& in, generator& g) {
        in.edge = hls::detail::two(static_cast<int>(g.below(3)));
        in.axis = hls::detail::two(static_cast<int>(g.below(3)));
      },
      agrees, vector_count() / 2);
}

TEST(remeshing_plane, hls_equals_golden_on_triangles) {
  for_vectors<input>(
      [](input& in, generator& g) {
        const int size = g.chance(2) ? 6 : 16383;
        in = plane_word(g.chance(2) ? draw_triangle(g, size) : draw_sliver(g, size));
      },
      [](input const& in) {
        const auto result = agrees(in);
        return result ? right(in) : result;
      },
      vector_count() / 2);
}

TEST(remeshing_plane, det_is_zero_exactly_on_one_line) {
  constexpr int r = 3;
  for (std::uint64_t number = 0; number < pairs_within(r); ++number) {
    const grid_triangle p = pair_of(number, r);
    const input in = plane_word(p);
    ASSERT_TRUE(right(in));
    bool line = true;
    for (std::size_t i = 0; i < 3; ++i) line &= p[1][i] * p[2][(i + 1) % 3] == p[1][(i + 1) % 3] * p[2][i];
    ASSERT_EQ(raw(hls::remeshing_plane(in).det) == 0, line) << text_of(p);
  }
}

TEST(remeshing_plane, the_largest_determinant_fits) {
  input in{};
  in.edge = hls::detail::two(0);
  in.axis = hls::detail::two(0);
  const int corner[3][2] = {{-32768, -32768}, {32767, -32768}, {32767, 32767}};
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 2; ++axis) in.p[i][axis] = hls::from_raw<formats::grid>(corner[i][axis]);
  EXPECT_EQ(raw(hls::remeshing_plane(in).det), std::int64_t{65535} * 65535);
}

}  // namespace
}  // namespace relievo::test
