// tessellate: hls equals golden on random triangles; the three patterns in every rotation against the tables of the paper's Figure 6;
// area and sense of turn kept; generations and settled edges by the rule; which diagonal, ties included.
#include "hls/edge/tessellate.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "golden/edge/tessellate.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

struct tessellate_regs {
  hls::map_regs map;
  hls::fixed<formats::generation> max_generation;
  RELIEVO_FIELDS(map, max_generation)
};
using vector = stimulus<hls::tessellate_in, tessellate_regs>;

int splits_of(hls::tessellate_in const& in) { return (in.split[0] ? 1 : 0) + (in.split[1] ? 1 : 0) + (in.split[2] ? 1 : 0); }

// What the engine can ask: at least one split edge, and those below the limit.
void askable(vector& v, generator& g) {
  size_within(v.regs.map.width, 8192, g);
  size_within(v.regs.map.height, 8192, g);
  for (auto* vertices : {v.in.t.v, v.in.m})
    for (int i = 0; i < 3; ++i) coordinates_within(vertices[i].u, v.regs.map, g);
  if (splits_of(v.in) == 0) v.in.split[g.below(3)] = true;
  if (raw(v.regs.max_generation) == 0) v.regs.max_generation = hls::from_raw<formats::generation>(1);
  for (int i = 0; i < 3; ++i)
    if (v.in.split[i]) v.in.t.generation[i] = hls::from_raw<formats::generation>(raw(v.in.t.generation[i]) % raw(v.regs.max_generation));
}

testing::AssertionResult agrees(vector const& v) {
  hls::tessellate_out out{};
  hls::tessellate(v.in, v.regs.map, v.regs.max_generation, out);
  golden::tessellate_in golden_in = as_golden<golden::tessellate_in>(v.in);
  const golden::tessellate_out right = golden::tessellate<golden::rounded>(golden_in, as_golden<golden::map_regs>(v.regs.map),
                                                                           static_cast<double>(raw(v.regs.max_generation)));
  if (raw(out.count) != right.count) return testing::AssertionFailure() << raw(out.count) << " triangles, golden " << right.count;
  for (int i = 0; i < right.count; ++i) {
    const auto result = equal_words(out.t[i], right.t[i]);
    if (!result) return testing::AssertionFailure() << "triangle " << i << ", " << result.message();
  }
  return testing::AssertionSuccess();
}

TEST(tessellate, hls_equals_golden) { for_vectors<vector>(askable, agrees, vector_count() * 3 / 4); }

// Two splits where the diagonals are equally long or nearly: a square, moved, turned and sometimes off by an LSB.
TEST(tessellate, hls_equals_golden_near_equal_diagonals) {
  std::uint64_t equal = 0;
  for_vectors<vector>(
      [](vector& v, generator& g) {
        askable(v, g);
        const std::uint64_t whole = g.below(3);
        for (std::uint64_t i = 0; i < 3; ++i) v.in.split[i] = i != whole;
        for (int i = 0; i < 3; ++i) v.in.t.generation[i] = hls::from_raw<formats::generation>(0);
        auto &a = v.in.t.v[whole], &b = v.in.t.v[(whole + 1) % 3], &p = v.in.m[(whole + 1) % 3], &q = v.in.m[(whole + 2) % 3];
        const std::int64_t x = g.between(-100000, 100000), y = g.between(-100000, 100000);
        const std::int64_t ox = g.between(-4000000, 4000000), oy = g.between(-4000000, 4000000);
        const auto put = [&](hls::vertex& w, std::int64_t px, std::int64_t py) {
          w.p[0] = hls::from_raw<formats::position>(ox + px);
          w.p[1] = hls::from_raw<formats::position>(oy + py + (g.chance(12) ? 1 : 0));
          w.p[2] = hls::from_raw<formats::position>(0);
        };
        // a b p q is a parallelogram with equal diagonals: a rectangle.
        put(a, 0, 0);
        put(b, x, y);
        put(p, x - y, y + x);
        put(q, -y, x);
        if (g.chance(8)) b = a;
      },
      [&](vector const& v) {
        int whole = 0;
        while (v.in.split[whole]) ++whole;
        equal += raw(hls::detail::squared_distance(v.in.t.v[whole], v.in.m[(whole + 1) % 3])) ==
                         raw(hls::detail::squared_distance(v.in.t.v[(whole + 1) % 3], v.in.m[(whole + 2) % 3]))
                     ? 1
                     : 0;
        return agrees(v);
      },
      vector_count() / 4);
  EXPECT_GT(equal, vector_count() / 20);
}

// ---- patterns by name: corners 0, 1, 2 and the new vertices 3, 4, 5 of edges 0, 1, 2 --------------------------------------------

using corner_list = std::vector<std::array<int, 3>>;

// Vertex names travel in t; positions are a right triangle in barycentric steps, so that areas are exact.
vector named(std::array<bool, 3> split) {
  vector v{};
  v.regs.map = {hls::from_raw<formats::map_size>(4), hls::from_raw<formats::map_size>(4), false, false};
  v.regs.max_generation = hls::from_raw<formats::generation>(9);
  const std::int64_t place[6][2] = {{0, 0}, {1200, 0}, {0, 800}, {600, 0}, {600, 400}, {0, 400}};
  for (int i = 0; i < 6; ++i) {
    hls::vertex& w = i < 3 ? v.in.t.v[i] : v.in.m[i - 3];
    w.t[0] = hls::from_raw<formats::unit>(i);
    for (int k = 0; k < 2; ++k) w.p[k] = hls::from_raw<formats::position>(place[i][k]);
  }
  for (int i = 0; i < 3; ++i) v.in.split[i] = split[static_cast<std::size_t>(i)];
  return v;
}
int name(hls::vertex const& v) { return static_cast<int>(raw(v.t[0])); }

corner_list corners_of(hls::tessellate_out const& out) {
  corner_list list;
  for (int i = 0; i < raw(out.count); ++i) list.push_back({name(out.t[i].v[0]), name(out.t[i].v[1]), name(out.t[i].v[2])});
  return list;
}
corner_list tessellated(vector const& v) {
  hls::tessellate_out out{};
  hls::tessellate(v.in, v.regs.map, v.regs.max_generation, out);
  return corners_of(out);
}

TEST(tessellate, one_split_in_every_rotation) {
  EXPECT_EQ(tessellated(named({true, false, false})), (corner_list{{0, 3, 2}, {3, 1, 2}}));
  EXPECT_EQ(tessellated(named({false, true, false})), (corner_list{{1, 4, 0}, {4, 2, 0}}));
  EXPECT_EQ(tessellated(named({false, false, true})), (corner_list{{2, 5, 1}, {5, 0, 1}}));
}

TEST(tessellate, two_splits_in_every_rotation_take_the_shorter_diagonal) {
  // Edge 0 whole: a-p is (0,0)-(600,400), b-q is (1200,0)-(0,400).
  EXPECT_EQ(tessellated(named({false, true, true})), (corner_list{{5, 4, 2}, {0, 1, 4}, {0, 4, 5}}));
  // Edge 1 whole: a-p is (1200,0)-(0,400), b-q is (0,800)-(600,0).
  EXPECT_EQ(tessellated(named({true, false, true})), (corner_list{{3, 5, 0}, {1, 2, 3}, {2, 5, 3}}));
  // Edge 2 whole: a-p is (0,800)-(600,0), b-q is (0,0)-(600,400).
  EXPECT_EQ(tessellated(named({true, true, false})), (corner_list{{4, 3, 1}, {2, 0, 4}, {0, 3, 4}}));
}

TEST(tessellate, three_splits) {
  EXPECT_EQ(tessellated(named({true, true, true})), (corner_list{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}));
}

// Equal diagonals: the end of the whole edge that comes first by value has one, wherever it stands in the record.
TEST(tessellate, equal_diagonals_go_to_the_end_that_comes_first_by_value) {
  for (int whole = 0; whole < 3; ++whole)
    for (const bool swapped : {false, true}) {
      std::array<bool, 3> split = {true, true, true};
      split[static_cast<std::size_t>(whole)] = false;
      vector v = named(split);
      const int b = (whole + 1) % 3, c = (whole + 2) % 3;
      // An isosceles triangle: a and b at the ends of its base, p and q half way up. Mirrored, it is the other one that comes first.
      const auto put = [](hls::vertex& w, std::int64_t x, std::int64_t y) {
        w.p[0] = hls::from_raw<formats::position>(x);
        w.p[1] = hls::from_raw<formats::position>(y);
      };
      const std::int64_t side = swapped ? 400 : -400;
      put(v.in.t.v[whole], side, 0);
      put(v.in.t.v[b], -side, 0);
      put(v.in.t.v[c], 0, swapped ? -600 : 600);
      put(v.in.m[b], -side / 2, swapped ? -300 : 300);
      put(v.in.m[c], side / 2, swapped ? -300 : 300);
      const corner_list parts = tessellated(v);
      const int a = whole, p = 3 + b, q = 3 + c;
      const corner_list first_has_it = {{q, p, c}, {a, b, p}, {a, p, q}}, second_has_it = {{q, p, c}, {a, b, q}, {b, p, q}};
      EXPECT_EQ(parts, swapped ? second_has_it : first_has_it) << "whole edge " << whole;
    }
}

TEST(tessellate, every_pattern_keeps_the_area_and_the_turn_of_its_triangle) {
  for (int pattern = 1; pattern < 8; ++pattern) {
    const vector v = named({(pattern & 1) != 0, (pattern & 2) != 0, (pattern & 4) != 0});
    hls::tessellate_out out{};
    hls::tessellate(v.in, v.regs.map, v.regs.max_generation, out);
    std::int64_t area = 0;
    for (int i = 0; i < raw(out.count); ++i) {
      const auto x = [&](int k) { return raw(out.t[i].v[k].p[0]); };
      const auto y = [&](int k) { return raw(out.t[i].v[k].p[1]); };
      const std::int64_t twice = (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
      EXPECT_GT(twice, 0) << "pattern " << pattern << ", triangle " << i;
      area += twice;
    }
    EXPECT_EQ(area, 1200 * 800) << "pattern " << pattern;
  }
}

// Edge by edge: halves are one generation on, whole edges keep theirs and are settled, new edges follow the split edges alone.
TEST(tessellate, generations_and_settled_edges) {
  generator g("edges");
  for (int round = 0; round < 20000; ++round) {
    const int pattern = static_cast<int>(g.between(1, 7));
    vector v = named({(pattern & 1) != 0, (pattern & 2) != 0, (pattern & 4) != 0});
    const std::int64_t limit = g.between(1, 15);
    v.regs.max_generation = hls::from_raw<formats::generation>(limit);
    std::int64_t highest = 0;
    std::map<std::set<int>, std::pair<std::int64_t, bool>> right;
    for (int i = 0; i < 3; ++i) {
      const std::int64_t generation = g.between(0, v.in.split[i] ? limit - 1 : 15);
      v.in.t.generation[i] = hls::from_raw<formats::generation>(generation);
      v.in.t.settled[i] = !v.in.split[i] && g.chance(2);
      const int a = i, b = (i + 1) % 3, m = 3 + i;
      if (v.in.split[i]) {
        highest = std::max(highest, generation);
        right[{a, m}] = right[{m, b}] = {generation + 1, generation + 1 >= limit};
      } else {
        right[{a, b}] = {generation, true};
      }
    }
    v.in.t.index = hls::from_raw<formats::index>(round);
    v.in.t.last = true;
    hls::tessellate_out out{};
    hls::tessellate(v.in, v.regs.map, v.regs.max_generation, out);
    ASSERT_EQ(raw(out.count), splits_of(v.in) + 1);
    for (int i = 0; i < raw(out.count); ++i) {
      EXPECT_EQ(raw(out.t[i].index), round);
      EXPECT_FALSE(out.t[i].last);
      for (int k = 0; k < 3; ++k) {
        const auto edge = right.find({name(out.t[i].v[k]), name(out.t[i].v[(k + 1) % 3])});
        const auto expected = edge != right.end() ? edge->second : std::pair<std::int64_t, bool>{highest + 1, highest + 1 >= limit};
        ASSERT_EQ(raw(out.t[i].generation[k]), expected.first) << "pattern " << pattern << ", triangle " << i << ", edge " << k;
        ASSERT_EQ(out.t[i].settled[k], expected.second) << "pattern " << pattern << ", triangle " << i << ", edge " << k;
      }
    }
  }
}

}  // namespace
}  // namespace relievo::test
