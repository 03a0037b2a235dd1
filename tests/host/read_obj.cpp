// read_obj: what a usable .obj becomes, and that each kind of bad input is refused with its line.
#include <gtest/gtest.h>

#include "tb/host/read_mesh.hpp"
#include "tests/support/refuses.hpp"

namespace relievo::test {
namespace {

std::string const quad = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 2\nf 1/1/1 2/2/1 3/3/1 4/4/1\n";

auto reading(std::string const& text) {
  return [text] { tb::read_obj(text, "a.obj"); };
}

std::string with(std::string text, std::string const& from, std::string const& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

TEST(read_obj, polygons_become_fans_and_normals_units) {
  const tb::mesh m = tb::read_obj(quad, "a.obj");
  ASSERT_EQ(m.vertices.size(), 4u);
  ASSERT_EQ(m.triangles.size(), 2u);
  EXPECT_EQ(m.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(m.triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
  EXPECT_EQ(m.vertices[2].n, glm::dvec3(0, 0, 1));
  EXPECT_EQ(m.vertices[2].u, glm::dvec2(1, 1));
  EXPECT_FALSE(m.has_tangents);
}

TEST(read_obj, negative_indices_count_back_and_odd_lines_are_passed_over) {
  std::string text = "# a comment\r\nmtllib x.mtl\no thing\ns off\nl 1 2\n" + quad;
  text = with(text, "f 1/1/1 2/2/1 3/3/1 4/4/1", "usemtl m\nf -4/-4/-1 -3/-3/-1 \\\n  -2/-2/-1 -1/-1/-1 # end");
  const tb::mesh m = tb::read_obj(text, "a.obj");
  EXPECT_EQ(m.vertices.size(), 4u);
  EXPECT_EQ(m.triangles.size(), 2u);
  EXPECT_EQ(m.vertices[3].p, glm::dvec3(-1, 1, 0));
}

TEST(read_obj, doubles_come_in_whole) {
  const tb::mesh m = tb::read_obj(with(quad, "v 1 1 0", "v 1.00000000001 +1e0 1.5e-3"), "a.obj");
  EXPECT_DOUBLE_EQ(m.vertices[2].p.x, 1.00000000001);
  EXPECT_DOUBLE_EQ(m.vertices[2].p.z, 1.5e-3);
}

TEST(read_obj, refuses_what_is_no_number) {
  EXPECT_TRUE(refuses(reading(with(quad, "v 1 1 0", "v 1 nan 0")), {"a.obj", "line 3", "nan"}));
  EXPECT_TRUE(refuses(reading(with(quad, "v 1 1 0", "v 1 inf 0")), {"line 3"}));
  EXPECT_TRUE(refuses(reading(with(quad, "v 1 1 0", "v 1 1e999 0")), {"line 3"}));
  EXPECT_TRUE(refuses(reading(with(quad, "v 1 1 0", "v 1 one 0")), {"line 3", "one"}));
  EXPECT_TRUE(refuses(reading(with(quad, "v 1 1 0", "v 1 1")), {"line 3", "3 numbers"}));
  EXPECT_TRUE(refuses(reading(with(quad, "vt 1 1", "vt 1")), {"line 7", "2 numbers"}));
}

TEST(read_obj, refuses_huge_coordinates) {
  EXPECT_TRUE(refuses(reading(with(quad, "v 1 1 0", "v 1e10 1 0")), {"a.obj", "position", "1e9"}));
}

TEST(read_obj, refuses_indices_out_of_range) {
  EXPECT_TRUE(refuses(reading(with(quad, "4/4/1", "5/4/1")), {"a.obj", "line 10", "out of range", "4 lines v"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4/4/1", "4/9/1")), {"4 lines vt"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4/4/1", "4/4/2")), {"1 lines vn"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4/4/1", "0/4/1")), {"out of range"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4/4/1", "-5/4/1")), {"out of range"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4/4/1", "99999999999999999999/4/1")), {"line 10"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4/4/1", "4/4/1/1")), {"line 10"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4/4/1", "x")), {"line 10"}));
}

TEST(read_obj, refuses_missing_attributes) {
  EXPECT_TRUE(refuses(reading(with(quad, "4/4/1", "4/4")), {"a.obj", "no normals", "vn"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4/4/1", "4//1")), {"no texture coordinates", "vt"}));
  EXPECT_TRUE(refuses(reading("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), {"no normals"}));
  EXPECT_TRUE(refuses(reading(with(quad, "vn 0 0 2", "vn 0 0 0")), {"vertex 0", "normal", "length"}));
}

TEST(read_obj, refuses_files_without_faces_or_text) {
  EXPECT_TRUE(refuses(reading(""), {"a.obj", "no faces"}));
  EXPECT_TRUE(refuses(reading("v 0 0 0\n"), {"no faces"}));
  EXPECT_TRUE(refuses(reading("f 1 2\n"), {"line 1", "3 corners"}));
  EXPECT_TRUE(refuses(reading(std::string("v 0 0 0\0", 8)), {"zero byte"}));
}

TEST(read_obj, refuses_degenerate_triangles_but_not_those_without_area) {
  EXPECT_TRUE(refuses(reading(with(quad, "3/3/1 4/4/1", "3/3/1 3/3/1")), {"a.obj", "triangle 1", "degenerate"}));
  EXPECT_NO_THROW(reading(with(quad, "v 1 1 0", "v 0 -1 0"))());
}

TEST(read_obj, refuses_non_manifold_meshes) {
  const std::string third = "v 0 0 5\nvt 0.5 1\nf 1/1/1 2/2/1 5/5/1\n", turned = "v 0 -5 0\nvt 0.5 0.5\nf 2/2/1 1/1/1 5/5/1\n";
  EXPECT_TRUE(refuses(reading(quad + third), {"a.obj", "triangle 2", "same direction"}));
  EXPECT_NO_THROW(reading(quad + turned)());
  EXPECT_TRUE(refuses(reading(quad + turned + "v 0 -5 1\nf 2/2/1 1/1/1 6/5/1\n"), {"triangle 3", "third triangle", "manifold"}));
}

TEST(read_obj, the_loose_form_takes_a_bare_mesh) {
  const tb::loose_mesh loose = tb::read_any_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(loose.m.vertices.size(), 3u);
  EXPECT_FALSE(loose.has_normals);
  EXPECT_FALSE(loose.has_coordinates);
}

}  // namespace
}  // namespace relievo::test
