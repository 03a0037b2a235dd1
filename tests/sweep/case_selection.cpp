// case_selection: hls equals golden; the cases by their pictures; widths add up; what each sub-triangle promises to the walk.
#include "hls/sweep/case_selection.hpp"

#include <gtest/gtest.h>

#include "golden/sweep/case_selection.hpp"
#include "tests/support/sweep_words.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using input = hls::case_selection_in;

testing::AssertionResult agrees(input const& in) {
  return equal_words(hls::case_selection(in), golden::case_selection(as_golden<golden::case_selection_in>(in)));
}

// The walk of a sub-triangle climbs, begins and ends where it says, and the two cover all columns.
testing::AssertionResult right(input const& in) {
  const auto out = hls::case_selection(in);
  const auto fails = [&] { return testing::AssertionFailure() << describe(in) << describe(out); };
  const std::int64_t s = raw(in.plane.s), t = raw(in.plane.t);
  const auto column = [&](hls::two_bits corner, bool backward) {
    return backward ? -raw(in.p[raw(corner)][s]) : raw(in.p[raw(corner)][s]);
  };
  const auto row = [&](hls::two_bits corner) { return in.plane.mirrored ? -raw(in.p[raw(corner)][t]) : raw(in.p[raw(corner)][t]); };
  std::int64_t width = 0;
  for (hls::sub_triangle const& sub : out.sub) {
    if (!sub.valid) continue;
    width += raw(sub.k1) - raw(sub.k0);
    if (raw(sub.k1) <= raw(sub.k0)) return fails() << "no width";
    if (row(sub.from) > row(sub.to)) return fails() << "the side edge falls";
    if (column(sub.from, sub.backward) != raw(sub.k0) || column(sub.to, sub.backward) != raw(sub.k1)) return fails() << "the wrong columns";
    const hls::two_bits begin = sub.backward ? in.plane.b : in.plane.a, end = sub.backward ? in.plane.a : in.plane.b;
    if (sub.starts_at_corner != (column(begin, sub.backward) == raw(sub.k0))) return fails() << "starts_at_corner";
    if (sub.pointed != (raw(sub.to) == raw(end))) return fails() << "pointed";
    if (sub.corner_list != (sub.starts_at_corner && raw(sub.from) != raw(begin))) return fails() << "corner_list";
    if (sub.ends_on_edge != (!sub.pointed && column(end, sub.backward) == raw(sub.k1))) return fails() << "ends_on_edge";
    if (sub.ends_on_edge && raw(sub.end_corner) != raw(end)) return fails() << "end_corner";
  }
  if (width != raw(in.p[raw(in.plane.b)][s]) - raw(in.p[raw(in.plane.a)][s])) return fails() << "columns are left";
  return testing::AssertionSuccess();
}

TEST(case_selection, hls_equals_golden) {
  for_vectors<input>(
      [](input& in, generator& g) {
        const int size = g.chance(2) ? 4 : 16383;
        in = case_word(g.chance(2) ? draw_triangle(g, size) : draw_sliver(g, size));
      },
      [](input const& in) {
        const auto result = agrees(in);
        return result ? right(in) : result;
      });
}

TEST(case_selection, every_triangle_of_a_grid) {
  constexpr int r = 3;
  std::array<std::uint64_t, 4> kinds{};
  for (std::uint64_t number = 0; number < pairs_within(r); ++number) {
    const input in = case_word(pair_of(number, r));
    ASSERT_TRUE(right(in));
    ++kinds[static_cast<std::size_t>(raw(hls::case_selection(in).kind))];
  }
  EXPECT_EQ(kinds[0], 1U) << "all corners equal";
  for (const std::uint64_t kind : kinds) EXPECT_GT(kind, 0U);
}

// Figure 13 a to c: A and B are p0 and p1, C is p2 above them.
TEST(case_selection, the_three_cases_of_figure_13) {
  const auto roof = hls::case_selection(case_word({{{0, 0, 0}, {9, 0, 0}, {4, 3, 0}}}));
  EXPECT_EQ(raw(roof.kind), hls::roof_case);
  EXPECT_FALSE(roof.sub[0].backward);
  EXPECT_TRUE(roof.sub[1].backward);
  EXPECT_EQ(raw(roof.sub[1].k0), -9);
  EXPECT_EQ(raw(roof.sub[1].k1), -4);
  const auto increasing = hls::case_selection(case_word({{{0, 0, 0}, {9, 5, 0}, {4, 4, 0}}}));
  EXPECT_EQ(raw(increasing.kind), hls::increasing_case);
  EXPECT_FALSE(increasing.sub[1].backward);
  EXPECT_EQ(raw(increasing.sub[1].from), 2);
  EXPECT_EQ(raw(increasing.sub[1].to), 1);
  const auto decreasing = hls::case_selection(case_word({{{0, 5, 0}, {9, 0, 0}, {4, 4, 0}}}));
  EXPECT_EQ(raw(decreasing.kind), hls::decreasing_case);
  EXPECT_TRUE(decreasing.sub[0].backward);
  EXPECT_EQ(raw(decreasing.sub[0].from), 1);
  EXPECT_EQ(raw(decreasing.sub[1].to), 0);
}

TEST(case_selection, vertical_side_edges) {
  // C over A: the roof ends on the edge from A; increasing begins with it.
  const auto roof = hls::case_selection(case_word({{{0, 0, 0}, {9, 0, 0}, {0, 4, 0}}}));
  EXPECT_FALSE(roof.sub[0].valid);
  EXPECT_TRUE(roof.sub[1].ends_on_edge);
  EXPECT_EQ(raw(roof.sub[1].end_corner), 0);
  const auto increasing = hls::case_selection(case_word({{{0, 0, 0}, {9, 6, 0}, {0, 4, 0}}}));
  EXPECT_FALSE(increasing.sub[0].valid);
  EXPECT_TRUE(increasing.sub[1].corner_list);
  EXPECT_TRUE(increasing.sub[1].starts_at_corner);
}

}  // namespace
}  // namespace relievo::test
