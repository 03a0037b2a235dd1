// Checks by words: rounded meshes are clean within the bound that their rounding implies, broken ones are not.
#include "tb/analysis/check_words.hpp"

#include <gtest/gtest.h>

#include "tb/analysis/open_edges.hpp"
#include "tests/analysis/made_mesh.hpp"

namespace relievo::test {
namespace {

// A size that makes every P and U but the corners round.
const golden::map_regs odd_map{404, 345, false, false};

made_mesh rounded_plane() {
  made_mesh m = cut_plane(3, 16, odd_map, true);
  drop_weights(m);
  return m;
}

tb::check_report check(made_mesh const& m) { return tb::check_output(m.out, m.base, m.map); }

TEST(check_words, rounded_plane_is_clean) {
  const auto r = check(rounded_plane());
  EXPECT_FALSE(r.exact);
  EXPECT_TRUE(r.with_base);
  EXPECT_TRUE(r.with_areas);
  EXPECT_TRUE(r.clean()) << tb::to_text(r);
  EXPECT_EQ(r.boundary_edges, 12u * 16u);
}

TEST(check_words, missing_triangle) {
  made_mesh m = rounded_plane();
  m.out.erase(m.out.begin() + 40);
  const auto r = check(m);
  EXPECT_EQ(r.open_edges, 3u);
  EXPECT_EQ(r.missing_area, 1u);
}

TEST(check_words, missing_base_triangle) {
  made_mesh m = plane(2, odd_map);
  for (std::size_t b = 0; b < 8; ++b) {
    if (b != 3) cut(m, b, 4, true);
  }
  drop_weights(m);
  const auto r = check(m);
  EXPECT_EQ(r.missing_area, 1u);
  EXPECT_GE(r.open_edges, 8u);
}

TEST(check_words, doubled_triangle) {
  made_mesh m = rounded_plane();
  m.out.push_back(m.out[40]);
  const auto r = check(m);
  EXPECT_EQ(r.overused_edges, 3u);
  EXPECT_EQ(r.excess_area, 1u);
}

TEST(check_words, flipped_triangle) {
  made_mesh m = rounded_plane();
  std::swap(m.out[40].v[0], m.out[40].v[1]);
  const auto r = check(m);
  EXPECT_EQ(r.flips, 1u);
  EXPECT_EQ(r.overused_edges, 3u);
}

TEST(check_words, t_vertices_inside_and_on_a_shared_side) {
  made_mesh m = rounded_plane();
  made_mesh inside = cut_plane(3, 16, odd_map, true);
  split_alone(inside, 1, 0, true);
  drop_weights(inside);
  EXPECT_EQ(check(inside).t_vertices, 1u);
  EXPECT_EQ(check(inside).open_edges, 3u);

  made_mesh side = plane(1, odd_map);
  cut(side, 0, 8, true);
  cut(side, 1, 16, true);
  drop_weights(side);
  EXPECT_EQ(check(side).t_vertices, 8u);
  EXPECT_EQ(check(side).open_edges, 24u);
}

TEST(check_words, parted_by_one_word_of_the_normal) {
  made_mesh m = rounded_plane();
  m.out[40].v[1].displaced_n.y += std::ldexp(1.0, -14);
  EXPECT_EQ(check(m).parted, 2u);
}

TEST(check_words, pole_is_a_border) {
  made_mesh m = pole();
  cut(m, 0, 4, true);
  cut(m, 1, 8, true);
  drop_weights(m);
  const auto r = check(m);
  EXPECT_TRUE(r.clean()) << tb::to_text(r);
  EXPECT_EQ(r.border_edges, 12u);
}

TEST(check_words, fold_along_the_tangent_is_a_border_by_its_normals_alone) {
  // Two planes meet along x: P, T and U of the ridge agree, only N doesn't, which output records don't hold.
  made_mesh m;
  m.map = {9, 9, false, false};
  const glm::dvec3 t(1, 0, 0);
  const glm::dvec3 up(0, 0, 1);
  const glm::dvec3 side(0, 1, 0);
  m.base.push_back(base_triangle_of(base_vertex_at({0, 0, 0}, up, t, {0, 4}), base_vertex_at({0, -1, 0}, up, t, {0, 0}),
                                    base_vertex_at({1, 0, 0}, up, t, {8, 4})));
  m.base.push_back(base_triangle_of(base_vertex_at({0, 0, 0}, side, t, {0, 4}), base_vertex_at({1, 0, 0}, side, t, {8, 4}),
                                    base_vertex_at({0, 0, -1}, side, t, {0, 8})));
  m.base[1].index = 1;
  cut(m, 0, 4);
  cut(m, 1, 4);
  EXPECT_EQ(check(m).border_edges, 8u) << "exact";
  drop_weights(m);
  const auto r = check(m);
  EXPECT_TRUE(r.clean()) << tb::to_text(r);
  EXPECT_EQ(r.border_edges, 8u);
  EXPECT_EQ(r.warnings.size(), 1u);
}

TEST(check_words, triangles_below_a_word_collapse_without_a_hole) {
  // A base triangle a few words wide, cut finer than its words.
  made_mesh m;
  m.map = {9, 9, false, false};
  const glm::dvec3 n(0, 0, 1);
  const glm::dvec3 t(1, 0, 0);
  const double word = std::ldexp(1.0, -20);
  const double texel = std::ldexp(1.0, -11);
  const auto a = base_vertex_at({0, 0, 0}, n, t, {0, 0});
  const auto b = base_vertex_at({2 * word, 0, 0}, n, t, {2 * texel, 0});
  const auto c = base_vertex_at({0, 2 * word, 0}, n, t, {0, 2 * texel});
  const auto d = base_vertex_at({2 * word, 2 * word, 0}, n, t, {2 * texel, 2 * texel});
  m.base.push_back(base_triangle_of(a, b, c));
  m.base.push_back(base_triangle_of(b, d, c));
  m.base[1].index = 1;
  cut(m, 0, 8, true);
  cut(m, 1, 8, true);
  EXPECT_EQ(check(m).degenerate, 0u) << "exact weights know better than words";
  drop_weights(m);
  const auto r = check(m);
  EXPECT_GT(r.collapsed, 0u);
  EXPECT_EQ(r.cracks(), 0u) << tb::to_text(r);
}

TEST(open_edges, vertex_beside_an_edge_in_u_or_t_is_not_on_it) {
  const std::vector<tb::open_vertex> v = {{{0, 0, 0}, {0, 0}, 0, {1, 0, 0}},
                                          {{1, 0, 0}, {8, 0}, 1, {1, 0, 0}},
                                          {{0.5, 0, 0}, {4, 0}, 2, {1, 0, 0}},
                                          {{0.25, 0, 0}, {2, 16}, 3, {0, 1, 0}}};
  tb::open_tolerance tolerance;
  tolerance.position = 1e-6;
  const std::vector<std::array<std::uint32_t, 2>> edges = {{0, 1}, {2, 3}};
  EXPECT_EQ(tb::vertices_inside_open_edges(v, edges, tolerance).size(), 2u);
  tolerance.use_u = true;
  tolerance.coordinate = 1e-6;
  EXPECT_EQ(tb::vertices_inside_open_edges(v, edges, tolerance), std::vector<std::uint32_t>{2});
  tolerance.turn = {0, 16};  // v = 16 is v = 0 again
  EXPECT_EQ(tb::vertices_inside_open_edges(v, edges, tolerance).size(), 2u);
  tolerance.use_t = true;
  EXPECT_EQ(tb::vertices_inside_open_edges(v, edges, tolerance), std::vector<std::uint32_t>{2});
}

}  // namespace
}  // namespace relievo::test
