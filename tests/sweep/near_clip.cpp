// near_clip: hls equals golden; both triangles at an edge get the same words; what is inside stays as it is; on a plane; a tenth vertex.
// Against the planes in real numbers: near_clip_exact.cpp.
#include "hls/sweep/near_clip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "golden/sweep/near_clip.hpp"
#include "tests/support/clipped_triangles.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::near_clip_in, hls::near_clip_regs>;

testing::AssertionResult agrees(vector const& v) {
  return equal_words(hls::near_clip(v.in, v.regs),
                     golden::near_clip(as_golden<golden::near_clip_in>(v.in), as_golden<golden::near_clip_regs>(v.regs)));
}

void around_the_planes(vector& v, generator& g) {
  const clipped_view s(g);
  v.regs = s.regs;
  for (auto& corner : v.in.vertex) corner = s.corner(g);
}

TEST(near_clip, hls_equals_golden_with_any_words) { for_vectors<vector>(any_word(), agrees, vector_count() / 20); }

TEST(near_clip, hls_equals_golden_around_the_planes) {
  std::uint64_t cut = 0, most = 0, number = 0;
  for_vectors<vector>(
      around_the_planes,
      [&](vector const& v) {
        const auto out = hls::near_clip(v.in, v.regs);
        ++number;
        cut += out.inside || out.empty ? 0 : 1;
        most = std::max(most, static_cast<std::uint64_t>(raw(out.count)));
        return agrees(v);
      },
      vector_count() / 10);
  EXPECT_GT(cut, number / 8);
  EXPECT_GE(most, 5U);
}

bool holds(polygon const& p, hls::base_vertex const& v) {
  return std::any_of(p.begin(), p.end(), [&v](hls::base_vertex const& other) { return static_cast<bool>(same_words(other, v)); });
}

// What is left of an edge alone: the triangle that goes there and back.
TEST(near_clip, both_triangles_at_an_edge_get_the_same_words) {
  generator g = next_generator();
  const std::uint64_t rounds = vector_count() / 100 + 1000;
  std::uint64_t cuts = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const clipped_view s(g);
    const hls::base_vertex a = s.corner(g), b = s.corner(g), c = s.corner(g), d = s.corner(g);
    const auto edge = hls::near_clip({{a, b, b}}, s.regs);
    const hls::near_clip_in sides[6] = {{{a, b, c}}, {{c, a, b}}, {{b, c, a}}, {{b, a, d}}, {{d, b, a}}, {{a, d, b}}};
    for (hls::near_clip_in const& side : sides) {
      const polygon words = vertices_of(hls::near_clip(side, s.regs));
      for (hls::base_vertex const& v : vertices_of(edge)) {
        ASSERT_TRUE(holds(words, v)) << "the edge's\n" << describe(v) << "of\n" << describe(vector{side, s.regs});
        cuts += edge.inside ? 0 : 1;
      }
    }
  }
  EXPECT_GT(cuts, rounds / 2);
}

// ---- by hand -----------------------------------------------------------------------------------------------------------------

// w is p[0], x is p[1], y is p[2]; near 1/16, far 4.
hls::near_clip_regs plain() {
  hls::near_clip_regs regs{};
  regs.transform.row_w[0] = hls::from_raw<formats::matrix_w>(1 << formats::matrix_w::fraction);
  regs.transform.row_x[1] = hls::from_raw<formats::matrix_xy>(1 << formats::matrix_xy::fraction);
  regs.transform.row_y[2] = hls::from_raw<formats::matrix_xy>(1 << formats::matrix_xy::fraction);
  regs.near = hls::from_raw<formats::depth>(1 << 16);
  regs.far = hls::from_raw<formats::depth>(4 << 20);
  regs.guard = true;
  return regs;
}
hls::base_vertex corner_at(std::int64_t w, std::int64_t x, std::int64_t y) {
  hls::base_vertex v{};
  v.p[0] = hls::from_raw<formats::position>(w);
  v.p[1] = hls::from_raw<formats::position>(x);
  v.p[2] = hls::from_raw<formats::position>(y);
  v.n[2] = v.t[0] = hls::from_raw<formats::unit>(1 << formats::unit::fraction);
  return v;
}

TEST(near_clip, on_a_plane_is_inside_and_one_lsb_beyond_is_not) {
  constexpr std::int64_t near = 1 << 16, far = 4 << 20;
  for (const std::int64_t outermost : {near, far}) {
    const hls::near_clip_in on = {{corner_at(outermost, 0, 0), corner_at(1 << 20, 5000, 0), corner_at(1 << 20, 0, 5000)}};
    const auto out = hls::near_clip(on, plain());
    EXPECT_TRUE(out.inside);
    EXPECT_EQ(raw(out.count), 3);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(same_words(out.vertex[i], on.vertex[i])) << "as they came";
    const hls::near_clip_in off = {{corner_at(outermost + (outermost == near ? -1 : 1), 0, 0), on.vertex[1], on.vertex[2]}};
    EXPECT_FALSE(hls::near_clip(off, plain()).inside);
    EXPECT_EQ(raw(hls::near_clip(off, plain()).count), 4);
    EXPECT_FALSE(hls::near_clip(off, plain()).empty);
  }
  // 8190 pixels to either side, while the guard is on: at w = 2^17 LSB there are no such positions, so rows of 2^10 pixels.
  for (int axis = 1; axis < 3; ++axis)
    for (const int side : {-1, 1})
      for (const int beyond : {0, 1}) {
        hls::near_clip_regs regs = plain();
        regs.transform.row_x[1] = regs.transform.row_y[2] = hls::from_raw<formats::matrix_xy>(1024 << formats::matrix_xy::fraction);
        const std::int64_t x = side * (8190 * 128 + beyond);
        const hls::near_clip_in in = {
            {corner_at(1 << 17, axis == 1 ? x : 0, axis == 2 ? x : 0), corner_at(1 << 20, 5, 0), corner_at(1 << 20, 0, 5)}};
        EXPECT_EQ(hls::near_clip(in, regs).inside, beyond == 0) << axis << " " << side;
        regs.guard = false;
        EXPECT_TRUE(hls::near_clip(in, regs).inside);
      }
}

TEST(near_clip, nothing_is_left_behind_the_eye) {
  const auto out = hls::near_clip({{corner_at(-1, 0, 0), corner_at(-(1 << 20), 5, 0), corner_at(0, 0, 5)}}, plain());
  EXPECT_TRUE(out.empty);
  EXPECT_FALSE(out.inside);
  EXPECT_EQ(raw(out.count), 0);
  EXPECT_TRUE(same_words(out.vertex[0], hls::base_vertex{}));
}

// N of the ends is opposite, and the cut half-way: a zero vector is (0,0,1) for N, (1,0,0) for T.
TEST(near_clip, opposite_normals_have_a_direction_all_the_same) {
  hls::base_vertex a = corner_at(0, 0, 0), b = corner_at(1 << 17, 0, 0);
  a.n[1] = a.t[1] = hls::from_raw<formats::unit>(9000);
  b.n[1] = b.t[1] = hls::from_raw<formats::unit>(-9000);
  a.n[2] = b.n[2] = a.t[0] = b.t[0] = {};
  const auto out = hls::near_clip({{a, b, b}}, plain());
  ASSERT_EQ(raw(out.count), 4);
  EXPECT_EQ(raw(out.vertex[0].p[0]), 1 << 16);
  EXPECT_EQ(raw(out.vertex[0].n[2]), 1 << 14);
  EXPECT_EQ(raw(out.vertex[0].t[0]), 1 << 14);
}

// Rounding makes the polygon wavy. Found by a search that climbed to it, among triangles and planes a few LSB apart; none larger is known.
TEST(near_clip, a_tenth_vertex_is_left_out_and_told) {
  const std::int64_t p[3][3] = {{-6, -1, 4}, {1, 11, -11}, {9, 2, -14}};
  const std::int64_t rows[3][3] = {{33518442, 33492344, 32588072}, {32918329, 31633990, 33050199}, {5911608, -4535785, -3219479}};
  vector v{};
  for (int i = 0; i < 3; ++i) {
    v.in.vertex[i] = corner_at(p[i][0], p[i][1], p[i][2]);
    v.regs.transform.row_x[i] = hls::from_raw<formats::matrix_xy>(rows[0][i]);
    v.regs.transform.row_y[i] = hls::from_raw<formats::matrix_xy>(rows[1][i]);
    v.regs.transform.row_w[i] = hls::from_raw<formats::matrix_w>(rows[2][i]);
  }
  v.regs.transform.offset_x = hls::from_raw<formats::offset_xy>(553104998400);
  v.regs.transform.offset_y = hls::from_raw<formats::offset_xy>(553127510016);
  v.regs.transform.offset_w = hls::from_raw<formats::offset_w>(69172461568);
  v.regs.near = hls::from_raw<formats::depth>(4121);
  v.regs.far = hls::from_raw<formats::depth>(4127);
  v.regs.guard = true;
  const auto out = hls::near_clip(v.in, v.regs);
  EXPECT_TRUE(out.overflow);
  EXPECT_EQ(raw(out.count), hls::clipped_vertices_max);
  EXPECT_TRUE(agrees(v));
}

}  // namespace
}  // namespace relievo::test
