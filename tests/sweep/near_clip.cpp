// near_clip: hls equals golden; both triangles at an edge get the same words; the polygon is the triangle within the planes; a cut lies on
// its plane and has the data of its place; what is inside stays as it is; a tenth vertex.
#include "hls/sweep/near_clip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "golden/sweep/near_clip.hpp"
#include "tests/support/world_words.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::near_clip_in, hls::near_clip_regs>;
using polygon = std::vector<hls::base_vertex>;

testing::AssertionResult agrees(vector const& v) {
  return equal_words(hls::near_clip(v.in, v.regs),
                     golden::near_clip(as_golden<golden::near_clip_in>(v.in), as_golden<golden::near_clip_regs>(v.regs)));
}

polygon vertices_of(hls::near_clip_out const& out) { return polygon(std::begin(out.vertex), std::begin(out.vertex) + raw(out.count)); }

// A camera that looks at the cube, and triangles of any size around a place that it may see.
struct seen {
  view_camera camera;
  hls::near_clip_regs regs{};
  place at;
  long double size;

  explicit seen(generator& g) : camera(draw_camera(g)), at(draw_place(g, 7)), size(std::ldexp(1.0L, -static_cast<int>(g.below(20)))) {
    regs.transform = camera.regs;
    regs.near = camera.near;
    regs.far = camera.far;
    regs.guard = !g.chance(4);
    // Where a plane is: near, far, or a side of the guard band, before the near plane.
    const auto pixels = [&g](std::int64_t most) { return static_cast<long double>(g.between(-most, most)); };
    const bool at_a_side = g.chance(2);
    const long double w = at_a_side     ? std::ldexp(value(regs.near), 1 + static_cast<int>(g.below(6)))
                          : g.chance(2) ? value(regs.near)
                                        : value(regs.far);
    long double x = pixels(8190), y = pixels(8190);
    if (at_a_side) (g.chance(2) ? x : y) = g.chance(2) ? 8190 : -8190;
    const place there = camera.at(x * w, y * w, w);
    if (product(there, there) < 49) at = there;
    if (!g.chance(3)) size = std::min(2.0L, std::ldexp(w, 2 - static_cast<int>(g.below(5))));
  }
  hls::base_vertex corner(generator& g) const { return draw_corner(g, at, size); }
};

void around_the_planes(vector& v, generator& g) {
  const seen s(g);
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
    const seen s(g);
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

// ---- against the planes in long double -------------------------------------------------------------------------------------

struct exact_vertex {
  place p, n;
  std::array<long double, 6> data;  // u, colour
};
exact_vertex exact_of(hls::base_vertex const& v) {
  exact_vertex e{place_of(v.p), place_of(v.n), {}};
  for (std::size_t i = 0; i < 2; ++i) e.data[i] = value(v.u[i]);
  for (std::size_t i = 0; i < 4; ++i) e.data[2 + i] = value(v.colour[i]);
  return e;
}
exact_vertex exact_between(exact_vertex const& a, exact_vertex const& b, long double r) {
  exact_vertex e;
  for (std::size_t i = 0; i < 3; ++i) {
    e.p[i] = a.p[i] + (b.p[i] - a.p[i]) * r;
    e.n[i] = a.n[i] + (b.n[i] - a.n[i]) * r;
  }
  for (std::size_t i = 0; i < 6; ++i) e.data[i] = a.data[i] + (b.data[i] - a.data[i]) * r;
  return e;
}

constexpr long double lsb = 1.0L / (1 << formats::position::fraction);
constexpr std::size_t guard_planes = 2;

std::size_t planes(seen const& s) { return s.regs.guard ? 6 : guard_planes; }
long double distance(seen const& s, std::size_t plane, place const& p) {
  const long double w = s.camera.depth(p);
  if (plane == 0) return w - value(s.regs.near);
  if (plane == 1) return value(s.regs.far) - w;
  const long double across = s.camera.clip(p, plane < 4 ? 0 : 1);
  return 8190 * w + (plane % 2 == 0 ? across : -across);
}
// What the roundings of w, and of x or y, move it by.
long double noise(std::size_t plane) { return (plane < guard_planes ? 1 : 8191) * lsb / 2; }

// An edge that one plane cuts: the vertex lies where the plane does, and has the data of that place.
testing::AssertionResult lies_on_the_plane(seen const& s, std::size_t plane, hls::base_vertex const& inside,
                                           hls::base_vertex const& outside, hls::base_vertex const& cut) {
  const exact_vertex a = exact_of(inside), b = exact_of(outside), got = exact_of(cut);
  const long double da = distance(s, plane, a.p), db = distance(s, plane, b.p), all = da - db - 2 * noise(plane);
  if (all <= 4 * noise(plane)) return testing::AssertionSuccess();
  const long double off = 2 * noise(plane) / all + std::ldexp(1.0L, -24) + std::ldexp(1.0L, -26);
  const exact_vertex right = exact_between(a, b, da / (da - db));
  const auto within = [off](long double x, long double exact, long double difference, long double half) {
    return std::abs(x - exact) <= std::abs(difference) * off + half * 1.001L;
  };
  for (std::size_t i = 0; i < 3; ++i)
    if (!within(got.p[i], right.p[i], b.p[i] - a.p[i], lsb / 2)) return testing::AssertionFailure() << "p[" << i << "]";
  for (std::size_t i = 0; i < 6; ++i)
    if (!within(got.data[i], right.data[i], b.data[i] - a.data[i],
                std::ldexp(0.5L, i < 2 ? -formats::coordinate::fraction : -formats::colour::fraction)))
      return testing::AssertionFailure() << (i < 2 ? "u" : "colour");
  const long double length = std::sqrt(product(right.n, right.n)), half_unit = std::ldexp(1.0L, -15);
  const place across = moved(b.n, -1, a.n);
  const long double turned = std::sqrt(product(across, across)) * off + 1.7321L * half_unit;
  if (length < 2 * turned) return testing::AssertionSuccess();
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(got.n[i] - right.n[i] / length) > 2 * turned / (2 * length - turned) + half_unit)
      return testing::AssertionFailure() << "n";
  return testing::AssertionSuccess();
}

TEST(near_clip, a_cut_lies_on_its_plane_with_the_data_of_its_place) {
  generator g = next_generator();
  std::array<std::uint64_t, 6> cuts{};
  for (std::uint64_t round = 0; round < vector_count() / 50 + 4000; ++round) {
    const seen s(g);
    const hls::base_vertex a = s.corner(g), b = s.corner(g);
    std::size_t plane = 6;
    for (std::size_t i = 0; i < planes(s); ++i)
      if (distance(s, i, place_of(a.p)) < noise(i) || distance(s, i, place_of(b.p)) < noise(i)) plane = plane == 6 ? i : 7;
    if (plane > 5 || distance(s, plane, place_of(a.p)) < noise(plane) || distance(s, plane, place_of(b.p)) > -noise(plane)) continue;
    const polygon there = vertices_of(hls::near_clip({{a, b, b}}, s.regs));
    if (there.size() != 3) continue;  // the cut is a hair beyond another plane, or its own
    ++cuts[plane];
    ASSERT_TRUE(lies_on_the_plane(s, plane, a, b, there[1])) << "plane " << plane << "\n" << describe(vector{{{a, b, b}}, s.regs});
  }
  for (const std::uint64_t n : cuts) EXPECT_GT(n, 0U);
}

// Twice the area, as a vector.
place area_of(std::vector<exact_vertex> const& p) {
  place sum{};
  for (std::size_t i = 2; i < p.size(); ++i) sum = moved(sum, 1, across(moved(p[i - 1].p, -1, p[0].p), moved(p[i].p, -1, p[0].p)));
  return sum;
}

std::vector<exact_vertex> exactly_clipped(seen const& s, std::vector<exact_vertex> p) {
  for (std::size_t plane = 0; plane < planes(s); ++plane) {
    std::vector<exact_vertex> out;
    for (std::size_t i = 0; i < p.size(); ++i) {
      exact_vertex const &a = p[i], &b = p[(i + 1) % p.size()];
      const long double da = distance(s, plane, a.p), db = distance(s, plane, b.p);
      if (da >= 0) out.push_back(a);
      if ((da >= 0) != (db >= 0)) out.push_back(exact_between(a, b, da / (da - db)));
    }
    p = out;
  }
  return p;
}

// How fast the distance changes within the triangle.
long double slope(seen const& s, std::size_t plane, std::vector<exact_vertex> const& p) {
  const place u = moved(p[1].p, -1, p[0].p), v = moved(p[2].p, -1, p[0].p), normal = across(u, v);
  const long double d = distance(s, plane, p[0].p), du = distance(s, plane, p[1].p) - d, dv = distance(s, plane, p[2].p) - d;
  return std::sqrt(std::max(du * du * product(v, v) - 2 * du * dv * product(u, v) + dv * dv * product(u, u), 0.0L) /
                   product(normal, normal));
}

// The fan covers what the planes leave. A plane is off by its noise and the rounding of a position, over its slope, along the longest edge.
TEST(near_clip, the_polygon_is_the_triangle_within_the_planes) {
  generator g = next_generator();
  const std::uint64_t rounds = vector_count() / 50 + 4000;
  std::uint64_t compared = 0, corners = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const seen s(g);
    const hls::near_clip_in in = {{s.corner(g), s.corner(g), s.corner(g)}};
    const std::vector<exact_vertex> whole = {exact_of(in.vertex[0]), exact_of(in.vertex[1]), exact_of(in.vertex[2])};
    const place all = area_of(whole);
    if (product(all, all) < 1e-16L) continue;
    long double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const place edge = moved(whole[(i + 1) % 3].p, -1, whole[i].p);
      longest = std::max(longest, std::sqrt(product(edge, edge)));
    }
    long double allowed = 9 * 2 * longest * lsb;
    for (std::size_t plane = 0; plane < planes(s); ++plane)
      allowed += 2 * longest * (2 * noise(plane) / slope(s, plane, whole) + longest * std::ldexp(1.0L, -24));
    const auto out = hls::near_clip(in, s.regs);
    ASSERT_FALSE(out.overflow);
    std::vector<exact_vertex> got;
    for (hls::base_vertex const& v : vertices_of(out)) got.push_back(exact_of(v));
    const place area = area_of(got), right = area_of(exactly_clipped(s, whole)), off = moved(area, -1, right);
    ASSERT_LE(std::sqrt(product(off, off)), allowed) << describe(vector{in, s.regs});
    if (out.inside || out.empty || product(right, right) < 1e6L * allowed * allowed) continue;
    ++compared;
    corners += got.size() > 4 ? 1 : 0;
  }
  EXPECT_GT(compared, rounds / 40);
  EXPECT_GT(corners, rounds / 1000);
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
