// near_clip_neighbours: two triangles at one edge have the same words where planes cut it, from whichever corner either begins and in
// whichever direction it goes; and a polygon never holds more than nine vertices.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "tests/support/world_views.hpp"

namespace relievo::test {
namespace {

using namespace golden;

bool same_words(base_vertex const& a, base_vertex const& b) {
  return a.p == b.p && a.n == b.n && a.t == b.t && a.u == b.u && a.colour == b.colour;
}

// What is left of the edge from a to b, by itself; false where nothing is.
bool clip_edge(base_vertex& a, base_vertex& b, near_clip_regs const& regs, int& cuts) {
  for (const clip_plane plane : all_clip_planes) {
    if (!is_used(plane, regs)) continue;
    const double da = clip_distance(plane, a.p, regs), db = clip_distance(plane, b.p, regs);
    if (da < 0 && db < 0) return false;
    if (da >= 0 && db >= 0) continue;
    (da < 0 ? a : b) = cut_vertex(a, b, da, db);
    ++cuts;
  }
  return true;
}

// Whether `second` comes after `first` around the polygon.
bool has_edge(near_clip_out const& polygon, base_vertex const& first, base_vertex const& second) {
  for (int i = 0; i < polygon.count; ++i)
    if (same_words(polygon.vertex[i], first) && (same_words(first, second) || same_words(polygon.vertex[(i + 1) % polygon.count], second)))
      return true;
  return false;
}

TEST(near_clip_neighbours, both_triangles_at_an_edge_have_the_same_words) {
  draw d(seed());
  std::uint64_t seen[3] = {}, gone = 0;
  for (std::uint64_t n = 0; n < rounds(500) + 200; ++n) {
    const world_view view = draw_view(d);
    for (int k = 0; k < 40; ++k) {
      const near_clip_in one = draw_triangle_at(d, view);
      base_vertex a = one.vertex[0], b = one.vertex[1];
      // The seam of a wrapped map: the words differ on its two sides, and are the same on one.
      if (d.integer(0, 3) == 0) a.u.x = b.u.x = largest_coordinate;
      const base_vertex c = one.vertex[2], other = draw_triangle_at(d, view).vertex[d.integer(0, 2)];
      base_vertex first = a, second = b;
      int cuts = 0;
      if (!clip_edge(first, second, view.clip, cuts)) {
        ++gone;
        continue;
      }
      ++seen[std::min(cuts, 2)];
      for (int turn = 0; turn < 3; ++turn) {
        near_clip_in there, back;
        const base_vertex here[3] = {a, b, c}, away[3] = {b, a, other};
        for (int i = 0; i < 3; ++i) {
          there.vertex[i] = here[(i + turn) % 3];
          back.vertex[i] = away[(i + turn) % 3];
        }
        ASSERT_TRUE(has_edge(near_clip(there, view.clip), first, second)) << "turn " << turn << ", " << cuts << " cuts";
        ASSERT_TRUE(has_edge(near_clip(back, view.clip), second, first)) << "turn " << turn << ", " << cuts << " cuts";
      }
    }
  }
  std::printf("edges whole %llu, cut once %llu, more often %llu, gone %llu\n", static_cast<unsigned long long>(seen[0]),
              static_cast<unsigned long long>(seen[1]), static_cast<unsigned long long>(seen[2]), static_cast<unsigned long long>(gone));
  for (const std::uint64_t count : seen) EXPECT_GT(count, rounds(500) / 2);
}

// Found by climbing: rows of no camera, with w of a few LSB, so that the roundings of w times 8190 are all there is of the band.
TEST(near_clip_neighbours, a_tenth_vertex_is_left_out) {
  const auto row = [](double x, double y, double z, int fraction) { return glm::dvec3(x, y, z) * power_of_two(-fraction); };
  near_clip_regs regs;
  regs.transform.row_x = row(-560, -929, -1113, formats::matrix_xy::fraction);
  regs.transform.row_y = row(441, -68, 1072, formats::matrix_xy::fraction);
  regs.transform.row_w = row(-110353, -22174940, -2063408, formats::matrix_w::fraction);
  regs.transform.offset_x = 162163483 * range_of<formats::offset_xy>::lsb;
  regs.transform.offset_y = 122184774 * range_of<formats::offset_xy>::lsb;
  regs.transform.offset_w = -85699242558 * range_of<formats::offset_w>::lsb;
  regs.far = 255;
  regs.guard = true;
  near_clip_in in;
  in.vertex[0].p = row(-2925848, -5344979, 1525762, formats::position::fraction);
  in.vertex[1].p = row(6778219, 4909336, -2824145, formats::position::fraction);
  in.vertex[2].p = row(-1256334, -2249553, -8005845, formats::position::fraction);

  std::vector<base_vertex> polygon(in.vertex, in.vertex + 3);
  for (const clip_plane plane : all_clip_planes) {
    std::vector<base_vertex> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      base_vertex const &v = polygon[i], &next = polygon[(i + 1) % polygon.size()];
      const double here = clip_distance(plane, v.p, regs), there = clip_distance(plane, next.p, regs);
      if (here >= 0) kept.push_back(v);
      if ((here < 0) != (there < 0)) kept.push_back(cut_vertex(v, next, here, there));
    }
    polygon = kept;
    std::printf("%zu ", polygon.size());
  }
  std::printf("vertices after each plane\n");
  const near_clip_out out = near_clip(in, regs);
  ASSERT_EQ(polygon.size(), 10U);
  EXPECT_TRUE(out.overflow);
  EXPECT_EQ(out.count, 9);
  for (int i = 0; i < out.count; ++i) EXPECT_TRUE(same_words(out.vertex[i], polygon[static_cast<std::size_t>(i)])) << i;
}

}  // namespace
}  // namespace relievo::test
