// write_mesh: sharing of vertices, the three formats, the second pass, and that nothing is left behind when writing fails.
#include "tb/host/write_mesh.hpp"

#include <gtest/gtest.h>

#include "tb/host/read_mesh.hpp"
#include "tb/host/welded.hpp"
#include "tests/support/refuses.hpp"
#include "tests/support/temporary_folder.hpp"

namespace relievo::test {
namespace {

tb::scene plane() {
  tb::scene_options o;
  o.mesh = "plane:2";
  o.displacement = "half-donut:33,17";
  return tb::make_scene(o);
}

// The base triangles, lifted by an eighth along the normal, as an engine would put them out; an empty record at the end.
std::vector<golden::triangle_out> lifted(tb::scene const& sc) {
  std::vector<golden::triangle_out> out;
  for (golden::triangle const& t : sc.triangles) {
    golden::triangle_out o;
    o.index = t.index;
    for (int k = 0; k < 3; ++k) {
      golden::vertex v = t.v[k];
      v.displaced_p = v.p + 0.125 * v.n;
      v.displaced_n = glm::dvec3(0.5, 0, 0.8660278);
      v.displaced_n.z = std::floor(v.displaced_n.z * 16384) / 16384;
      o.v[k] = golden::leaving(v);
    }
    out.push_back(o);
  }
  golden::triangle_out empty;
  empty.empty = empty.last = true;
  out.push_back(empty);
  return out;
}

TEST(write_mesh, vertices_are_shared_where_all_words_agree) {
  const tb::scene sc = plane();
  auto triangles = lifted(sc);
  EXPECT_EQ(tb::welded(triangles, sc).vertices.size(), 9u);
  EXPECT_EQ(tb::welded(triangles, sc).triangles.size(), 8u);
  triangles[0].v[0].displaced_n.x += 1.0 / 16384;
  EXPECT_EQ(tb::welded(triangles, sc).vertices.size(), 10u);
}

TEST(write_mesh, every_format_holds_the_displaced_mesh) {
  const temporary_folder folder;
  const tb::scene sc = plane();
  for (char const* extension : {"obj", "ply", "glb"}) {
    const std::string path = folder.file(std::string("out.") + extension);
    tb::write_mesh(path, lifted(sc), sc);
    const tb::mesh m = tb::read_mesh(path);
    ASSERT_EQ(m.vertices.size(), 9u) << extension;
    ASSERT_EQ(m.triangles.size(), 8u) << extension;
    EXPECT_EQ(m.has_tangents, std::string(extension) != "obj");
    for (auto const& v : m.vertices) {
      EXPECT_NEAR(v.p.z, 0.125 / sc.world_scale, 1e-9) << extension;
      EXPECT_NEAR(v.n.x, 0.5, 1e-4) << extension;
      EXPECT_NEAR(v.p.x, 2 * v.u.x - 1, 1e-6) << extension;
    }
    const std::string once = temporary_folder::bytes_of(path);
    tb::write_mesh(path, lifted(sc), sc);
    EXPECT_EQ(temporary_folder::bytes_of(path), once) << extension;
  }
  EXPECT_EQ(folder.entries(), 3u);
}

TEST(write_mesh, ply_holds_undisplaced_points_base_triangles_and_words) {
  const temporary_folder folder;
  const tb::scene sc = plane();
  tb::write_mesh(folder.file("out.ply"), lifted(sc), sc, true);
  const tb::mesh m = tb::read_mesh(folder.file("out.ply"));
  EXPECT_EQ(m.base_triangle, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
  ASSERT_EQ(m.raw.size(), 9u);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(m.undisplaced[i].z, 0.0);
    EXPECT_EQ(m.raw[i].displaced_p[2], 1 << 17);
    EXPECT_EQ(m.raw[i].p[0], std::lround(m.undisplaced[i].x * sc.world_scale * 1048576));
    EXPECT_EQ(m.raw[i].u[0], std::lround(m.vertices[i].u.x * 32 * 2048));
  }
  ASSERT_EQ(m.comments.size(), 1u);
  EXPECT_EQ(m.comments[0], "relievo world_scale 4 centre 0 0 0 map 33 17 clamp clamp");
}

TEST(write_mesh, the_output_is_the_base_of_a_second_pass) {
  const temporary_folder folder;
  const tb::scene sc = plane();
  for (char const* extension : {"obj", "ply", "glb"}) {
    tb::scene_options o;
    o.mesh = folder.file(std::string("out.") + extension);
    tb::write_mesh(o.mesh, lifted(sc), sc);
    o.displacement = "sine:33,17";
    const tb::scene second = tb::make_scene(o);
    EXPECT_TRUE(second.warnings.empty()) << extension;
    for (auto const& t : second.triangles)
      for (auto const& v : t.v) {
        EXPECT_EQ(v.p.z / second.world_scale, 0.125 / sc.world_scale);
        EXPECT_NEAR(glm::dot(v.t, v.n), 0, 2e-4);
        EXPECT_GT(v.t.x, 0.8);
        EXPECT_EQ(v.u * 2048.0, glm::floor(v.u * 2048.0));
      }
  }
}

TEST(write_mesh, raw_words_need_words) {
  const temporary_folder folder;
  const tb::scene sc = plane();
  auto triangles = lifted(sc);
  EXPECT_TRUE(refuses([&] { tb::write_mesh(folder.file("a.obj"), triangles, sc, true); }, {"a.obj", ".ply"}));
  triangles[3].v[1].displaced_p.x += 1e-9;
  EXPECT_TRUE(refuses([&] { tb::write_mesh(folder.file("a.ply"), triangles, sc, true); }, {"--raw", "ideal"}));
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(write_mesh, unwritable_outputs_are_refused_and_leave_nothing) {
  const temporary_folder folder;
  const tb::scene sc = plane();
  const auto writing = [&](std::string const& path) { return [&sc, path] { tb::write_mesh(path, lifted(sc), sc); }; };
  EXPECT_TRUE(refuses(writing(folder.file("a.stl")), {"a.stl", ".obj, .ply or .glb"}));
  EXPECT_TRUE(refuses(writing(folder.file("none/a.ply")), {"none/a.ply", "cannot be written"}));
  std::filesystem::create_directory(folder.file("folder.ply"));
  EXPECT_TRUE(refuses(writing(folder.file("folder.ply")), {"folder.ply", "folder"}));
  EXPECT_EQ(folder.entries(), 1u);
  EXPECT_TRUE(refuses([&] { tb::write_mesh(folder.file("a.glb"), {}, sc); }, {"a.glb", "without triangles"}));
  EXPECT_TRUE(refuses([&] { tb::read_mesh(folder.file("folder.ply")); }, {"folder.ply", "folder"}));
}

}  // namespace
}  // namespace relievo::test
