// Checks of files: bare meshes get what topology tells, the base mesh tells the rest.
#include <gtest/gtest.h>

#include "tb/analysis/check.hpp"
#include "tests/analysis/made_mesh.hpp"

namespace relievo::test {
namespace {

// As a reader gives it: one vertex per corner, U from 0 to 1.
tb::loose_mesh as_file(made_mesh const& m, bool ours) {
  tb::loose_mesh file;
  file.has_normals = file.has_coordinates = true;
  file.m.has_tangents = ours;
  const glm::dvec2 texels(m.map.wrap_u ? m.map.width : m.map.width - 1, m.map.wrap_v ? m.map.height : m.map.height - 1);
  for (auto const& t : m.out) {
    const auto first = static_cast<std::uint32_t>(file.m.vertices.size());
    for (auto const& v : t.v) {
      tb::base_vertex b;
      b.p = v.displaced_p;
      b.n = v.displaced_n;
      b.t = v.t;
      b.u = v.u / texels;
      file.m.vertices.push_back(b);
      if (ours) file.m.undisplaced.push_back(v.p);
    }
    file.m.triangles.push_back({first, first + 1, first + 2});
    if (ours) file.m.base_triangle.push_back(static_cast<std::uint32_t>(t.index));
  }
  if (ours) {
    file.m.comments.push_back("relievo world_scale 1 centre 0 0 0 map " + std::to_string(static_cast<int>(m.map.width)) + " " +
                              std::to_string(static_cast<int>(m.map.height)) + (m.map.wrap_u ? " wrap" : " clamp") +
                              (m.map.wrap_v ? " wrap" : " clamp"));
  }
  return file;
}

tb::mesh base_as_file(made_mesh const& m) {
  tb::mesh base;
  const glm::dvec2 texels(m.map.wrap_u ? m.map.width : m.map.width - 1, m.map.wrap_v ? m.map.height : m.map.height - 1);
  for (auto const& t : m.base) {
    const auto first = static_cast<std::uint32_t>(base.vertices.size());
    for (auto const& v : t.v) base.vertices.push_back({v.p, v.n, v.t, v.u / texels});
    base.triangles.push_back({first, first + 1, first + 2});
  }
  return base;
}

const golden::map_regs odd_map{404, 345, false, false};

TEST(check_file, our_ply_with_its_base_is_clean) {
  const made_mesh m = cut_plane(3, 8, odd_map, true);
  const auto r = tb::check_file(as_file(m, true), base_as_file(m));
  EXPECT_TRUE(r.clean()) << tb::to_text(r);
  EXPECT_TRUE(r.with_base);
  EXPECT_EQ(r.undecided_edges, 0u);
  EXPECT_EQ(r.boundary_edges, 12u * 8u);
}

TEST(check_file, our_ply_alone_leaves_the_boundary_undecided) {
  const made_mesh m = cut_plane(3, 8, odd_map, true);
  const auto r = tb::check_file(as_file(m, true));
  EXPECT_TRUE(r.clean()) << tb::to_text(r);
  EXPECT_FALSE(r.with_base);
  EXPECT_EQ(r.undecided_edges, 12u * 8u);
}

TEST(check_file, our_ply_alone_knows_a_border_and_a_t_vertex) {
  made_mesh m = pole();
  cut(m, 0, 4, true);
  cut(m, 1, 4, true);
  EXPECT_EQ(tb::check_file(as_file(m, true)).border_edges, 8u);
  made_mesh t = cut_plane(2, 8, odd_map, true);
  split_alone(t, 1, 0, true);
  const auto r = tb::check_file(as_file(t, true));
  EXPECT_EQ(r.t_vertices, 1u);
  EXPECT_FALSE(r.clean());
}

TEST(check_file, bare_mesh_gets_topology_only_or_its_base) {
  made_mesh m = cut_plane(3, 8, odd_map, true);
  auto file = as_file(m, false);
  auto r = tb::check_file(file);
  EXPECT_FALSE(r.with_base);
  EXPECT_FALSE(r.with_areas);
  EXPECT_EQ(r.undecided_edges, 12u * 8u);
  EXPECT_TRUE(r.clean());
  r = tb::check_file(file, base_as_file(m));
  EXPECT_TRUE(r.with_base);
  EXPECT_TRUE(r.with_areas);
  EXPECT_TRUE(r.clean()) << tb::to_text(r);
  EXPECT_EQ(r.boundary_edges, 12u * 8u);

  m.out.erase(m.out.begin() + 20);
  r = tb::check_file(as_file(m, false), base_as_file(m));
  EXPECT_EQ(r.open_edges, 3u);
  EXPECT_EQ(r.missing_area, 1u);
}

TEST(check_file, crack_in_a_bare_mesh) {
  made_mesh m = cut_plane(3, 8, odd_map, true);
  m.out[20].v[0].displaced_p.z += 0.01;
  const auto r = tb::check_file(as_file(m, false), base_as_file(m));
  EXPECT_EQ(r.open_edges, 4u);
}

TEST(check_file, base_that_uses_the_map_twice_is_said_to_be_no_help) {
  made_mesh m = plane(1, odd_map);
  made_mesh twin = m;
  for (auto& t : twin.base) {
    for (auto& v : t.v) v.p.x += 3;
    t.index += 2;
  }
  m.base.insert(m.base.end(), twin.base.begin(), twin.base.end());
  for (std::size_t b = 0; b < 4; ++b) cut(m, b, 4, true);
  const auto r = tb::check_file(as_file(m, false), base_as_file(m));
  EXPECT_FALSE(r.with_base);
  ASSERT_FALSE(r.warnings.empty());
  EXPECT_NE(r.warnings.back().find("share the map"), std::string::npos);
  EXPECT_TRUE(tb::check_file(as_file(m, true), base_as_file(m)).clean()) << "faces that name their base triangle are enough";
}

TEST(check_file, base_without_area_in_the_map_is_no_help_either) {
  made_mesh m = plane(1, {9, 9, false, false});
  for (auto& t : m.base) {
    for (auto& v : t.v) v.u.y = 0;
  }
  cut(m, 0, 4, true);
  cut(m, 1, 4, true);
  const auto r = tb::check_file(as_file(m, false), base_as_file(m));
  EXPECT_TRUE(r.clean()) << tb::to_text(r);
  EXPECT_FALSE(r.with_base);
  ASSERT_FALSE(r.warnings.empty());
  EXPECT_NE(r.warnings.back().find("no area in the map"), std::string::npos);
  EXPECT_TRUE(tb::check_file(as_file(m, true), base_as_file(m)).clean());
}

TEST(check_file, t_vertex_in_a_bare_mesh_but_not_across_a_border) {
  made_mesh t = cut_plane(2, 4, {257, 257, false, false}, true);
  for (auto& f : t.out) {
    for (auto& v : f.v) v.displaced_p = v.p;  // flat: the new vertex lies on the old edge
  }
  split_alone(t, 1, 0, true);
  for (auto& f : t.out) {
    for (auto& v : f.v) v.displaced_p = v.p;
  }
  EXPECT_EQ(tb::check_file(as_file(t, false)).t_vertices, 1u);
  made_mesh b = pole();
  cut(b, 0, 4, true);
  cut(b, 1, 8, true);
  for (auto& f : b.out) {
    for (auto& v : f.v) v.displaced_p = v.p;
  }
  EXPECT_EQ(tb::check_file(as_file(b, false)).t_vertices, 0u);
}

TEST(check_file, wrap_seam_closes_by_the_comment) {
  made_mesh m;
  m.map = {16, 5, true, false};
  const auto at = [&](double x, double y, double u, double v) { return base_vertex_at({x, y, 0}, {0, 0, 1}, {1, 0, 0}, {u, v}); };
  m.base.push_back(base_triangle_of(at(-1, 0, 8, 0), at(0, 0, 16, 0), at(0, 1, 16, 4)));
  m.base.push_back(base_triangle_of(at(0, 0, 0, 0), at(1, 0, 8, 0), at(0, 1, 0, 4)));
  m.base[1].index = 1;
  cut(m, 0, 4, true);
  cut(m, 1, 4, true);
  const auto r = tb::check_file(as_file(m, true), base_as_file(m));
  EXPECT_TRUE(r.clean()) << tb::to_text(r);
  EXPECT_EQ(r.border_edges, 0u);
}

}  // namespace
}  // namespace relievo::test
