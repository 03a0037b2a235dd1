// Exact checks: a whole mesh is clean, and every way to break one is seen and named.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tb/analysis/check.hpp"
#include "tests/analysis/made_mesh.hpp"

namespace relievo::test {
namespace {

tb::check_report check(made_mesh const& m, tb::check_options const& options = {}) {
  return tb::check_output(m.out, m.base, m.map, options);
}

TEST(check_exact, whole_plane_is_clean) {
  const auto r = check(cut_plane(2, 8));
  EXPECT_TRUE(r.exact);
  EXPECT_TRUE(r.clean()) << tb::to_text(r);
  EXPECT_EQ(r.triangles, 8u * 64u);
  EXPECT_EQ(r.boundary_edges, 8u * 8u);
  EXPECT_EQ(r.border_edges, 0u);
  EXPECT_EQ(2 * r.shared_edges + r.boundary_edges, 3 * r.triangles);
  EXPECT_TRUE(r.findings.empty());
  EXPECT_TRUE(r.warnings.empty());
}

TEST(check_exact, empty_records_are_no_triangles) {
  made_mesh m = cut_plane(1, 2);
  m.out.emplace_back();
  m.out.back().empty = m.out.back().last = true;
  EXPECT_TRUE(check(m).clean());
  EXPECT_EQ(check(m).triangles, 8u);
}

TEST(check_exact, nothing_put_out_is_missing_area) {
  made_mesh m = plane(1, {9, 9, false, false});
  EXPECT_EQ(check(m).missing_area, 2u);
  EXPECT_FALSE(check(m).clean());
}

TEST(check_exact, missing_triangle) {
  made_mesh m = cut_plane(1, 4);
  m.out.erase(m.out.begin() + 5);
  const auto r = check(m);
  EXPECT_EQ(r.missing_area, 1u);
  EXPECT_EQ(r.open_edges, 3u);
  EXPECT_EQ(r.t_vertices, 0u);
  EXPECT_FALSE(r.watertight());
}

TEST(check_exact, missing_triangle_at_the_boundary_is_seen_too) {
  made_mesh m = cut_plane(1, 4);
  m.out.erase(m.out.begin());  // the corner of the plane
  const auto r = check(m);
  EXPECT_EQ(r.missing_area, 1u);
  EXPECT_GE(r.open_edges, 1u);
}

TEST(check_exact, culled_triangles_are_no_fault_but_flips_still_are) {
  made_mesh m = cut_plane(1, 4);
  m.out.erase(m.out.begin() + 5);
  EXPECT_TRUE(check(m, {true}).clean());
  std::swap(m.out[2].v[0], m.out[2].v[1]);
  EXPECT_EQ(check(m, {true}).flips, 1u);
}

TEST(check_exact, doubled_triangle) {
  made_mesh m = cut_plane(1, 4);
  m.out.push_back(m.out[5]);
  const auto r = check(m);
  EXPECT_EQ(r.excess_area, 1u);
  EXPECT_EQ(r.overused_edges, 3u);
}

TEST(check_exact, flipped_triangle) {
  made_mesh m = cut_plane(1, 4);
  std::swap(m.out[5].v[0], m.out[5].v[2]);
  const auto r = check(m);
  EXPECT_EQ(r.flips, 1u);
  EXPECT_EQ(r.missing_area, 1u);
  EXPECT_GT(r.overused_edges, 0u);
}

TEST(check_exact, degenerate_triangle) {
  made_mesh m = cut_plane(1, 4);
  golden::triangle_out sliver = m.out[0];  // corners 0 and 1 and their middle: no area
  std::array<std::int64_t, 3> w{};
  for (std::size_t k = 0; k < 3; ++k) w[k] = (sliver.v[0].barycentric[k] + sliver.v[1].barycentric[k]) / 2;
  sliver.v[2] = vertex_at(m.base[0], w, false);
  m.out.push_back(sliver);
  const auto r = check(m);
  EXPECT_EQ(r.degenerate, 1u);
  EXPECT_EQ(r.excess_area + r.missing_area, 0u);
  EXPECT_FALSE(r.clean());
}

TEST(check_exact, t_vertex_inside_a_base_triangle) {
  made_mesh m = cut_plane(1, 4);
  split_alone(m, 1, 2);  // triangle 1 is the second of the first pair: all its edges are inside
  const auto r = check(m);
  EXPECT_EQ(r.t_vertices, 1u);
  EXPECT_EQ(r.open_edges, 3u);
  EXPECT_EQ(r.missing_area, 0u);
}

TEST(check_exact, t_vertex_on_a_shared_side) {
  made_mesh m = plane(1, {9, 9, false, false});
  cut(m, 0, 1);
  cut(m, 1, 2);
  const auto r = check(m);
  EXPECT_EQ(r.t_vertices, 1u);
  EXPECT_EQ(r.open_edges, 3u);
}

TEST(check_exact, crack_by_position_and_by_normal) {
  made_mesh m = plane(1, {9, 9, false, false});
  cut(m, 0, 4);
  const std::size_t second = m.out.size();
  cut(m, 1, 4);
  ASSERT_TRUE(check(m).clean());
  // The second base triangle's vertex at the middle of the diagonal, everywhere in it: whole inside, parted from the neighbour.
  const glm::dvec3 middle(0.0);
  made_mesh moved = m;
  made_mesh bent = m;
  for (std::size_t i = second; i < m.out.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      if (m.out[i].v[k].p != middle) continue;
      moved.out[i].v[k].displaced_p.z += std::ldexp(1.0, -20);
      bent.out[i].v[k].displaced_n.x += std::ldexp(1.0, -14);
    }
  }
  EXPECT_EQ(check(moved).parted, 2u);  // the two edges that end there
  EXPECT_EQ(check(bent).parted, 2u);
  EXPECT_EQ(check(bent).cracks(), 2u);
}

TEST(check_exact, one_vertex_with_two_records_inside_a_base_triangle) {
  made_mesh m = cut_plane(1, 4);
  m.out[1].v[0].displaced_p.z += std::ldexp(1.0, -20);
  const auto r = check(m);
  EXPECT_EQ(r.parted, 1u);
}

TEST(check_exact, pole_is_a_border_and_may_be_cut_differently) {
  made_mesh m = pole();
  cut(m, 0, 4);
  cut(m, 1, 8);
  const auto r = check(m);
  EXPECT_TRUE(r.clean()) << tb::to_text(r);
  EXPECT_EQ(r.border_edges, 4u + 8u);
  EXPECT_EQ(r.boundary_edges, 2u * 4u + 2u * 8u);
}

TEST(check_exact, the_same_mesh_without_the_border_cracks) {
  made_mesh m = pole();
  m.base[1].v[2] = m.base[0].v[2];
  cut(m, 0, 4);
  cut(m, 1, 8);
  const auto r = check(m);
  EXPECT_EQ(r.border_edges, 0u);
  EXPECT_EQ(r.t_vertices, 4u);
  EXPECT_EQ(r.open_edges, 12u);
}

TEST(check_exact, wrap_seam_is_shared_only_when_the_axis_wraps) {
  made_mesh m;
  m.map = {16, 5, true, false};
  const auto at = [&](double x, double y, double u, double v) { return base_vertex_at({x, y, 0}, {0, 0, 1}, {1, 0, 0}, {u, v}); };
  // The seam x = 0: u is 16 for the triangle on its left and 0 for the one on its right.
  m.base.push_back(base_triangle_of(at(-1, 0, 8, 0), at(0, 0, 16, 0), at(0, 1, 16, 4)));
  m.base.push_back(base_triangle_of(at(0, 0, 0, 0), at(1, 0, 8, 0), at(0, 1, 0, 4)));
  m.base[1].index = 1;
  cut(m, 0, 4);
  cut(m, 1, 4);
  EXPECT_TRUE(check(m).clean());
  EXPECT_EQ(check(m).border_edges, 0u);
  m.map.wrap_u = false;
  EXPECT_EQ(check(m).border_edges, 8u);
}

TEST(check_exact, stranger_to_the_base_mesh) {
  made_mesh m = cut_plane(1, 2);
  m.out[0].index = 7;
  m.out[1].v[0].barycentric[0] += 1;
  const auto r = check(m);
  EXPECT_EQ(r.outside, 2u);
  EXPECT_FALSE(r.clean());
}

TEST(check_exact, base_with_two_normals_at_a_position_warns) {
  made_mesh m = plane(1, {9, 9, false, false});
  m.base[1].v[0].n = {0, 1, 0};
  const auto r = check(m);
  ASSERT_EQ(r.warnings.size(), 1u);
  EXPECT_NE(r.warnings[0].find("1 position has vertices with different normals"), std::string::npos);
}

TEST(check_exact, report_names_the_place_as_json_and_text) {
  made_mesh m = cut_plane(1, 4);
  split_alone(m, 1, 2);
  const auto r = check(m);
  const auto json = tb::to_json(r);
  EXPECT_EQ(json["clean"], false);
  EXPECT_EQ(json["t_vertices"], 1);
  EXPECT_EQ(json["cracks"]["open"], 3);
  EXPECT_NE(tb::to_text(r).find("NOT watertight"), std::string::npos);
  EXPECT_NE(json["findings"].dump().find("T-vertex: base triangle 0 at U ("), std::string::npos);
}

}  // namespace
}  // namespace relievo::test
