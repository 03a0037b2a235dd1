// A scene's output measured and checked directly and through its files: the same figures, the same edges.
#include "tb/analysis/scene_surface.hpp"

#include <gtest/gtest.h>

#include "tb/analysis/check.hpp"
#include "tb/host/input_error.hpp"
#include "tb/host/write_mesh.hpp"
#include "tb/model/model.hpp"
#include "tests/support/temporary_folder.hpp"

namespace relievo::test {
namespace {

struct case_of {
  char const* mesh;
  char const* map;
  bool planar;
};

class scene_files : public testing::TestWithParam<case_of> {};

TEST_P(scene_files, say_what_the_output_says) {
  tb::scene_options options;
  options.mesh = GetParam().mesh;
  options.displacement = GetParam().map;
  options.scale = 0.2;
  options.max_generation = 5;
  options.tests.pt = true;
  const tb::scene sc = tb::make_scene(options);
  const auto out = tb::run_model("golden", sc).triangles;
  const auto checked = tb::check_output(out, sc.triangles, sc.regs.map);
  EXPECT_TRUE(checked.exact);
  EXPECT_TRUE(checked.clean()) << tb::to_text(checked);
  const auto error = tb::measure_error(out, sc);
  EXPECT_EQ(error.along_normal, GetParam().planar);
  EXPECT_GT(error.samples, 0u);
  EXPECT_LT(error.world.max, 0.2);

  const temporary_folder folder;
  for (char const* name : {"mesh.ply", "mesh.obj", "mesh.glb"}) {
    SCOPED_TRACE(name);
    tb::write_mesh(folder.file(name), out, sc);
    const tb::loose_mesh file = tb::read_any_mesh(folder.file(name));
    const auto again = tb::check_file(file, sc);
    EXPECT_TRUE(again.clean()) << tb::to_text(again);
    EXPECT_EQ(again.triangles, checked.triangles);
    EXPECT_EQ(again.shared_edges, checked.shared_edges);
    EXPECT_EQ(again.boundary_edges + again.border_edges + again.undecided_edges, checked.boundary_edges + checked.border_edges);
    const auto measured = tb::measure_error(tb::world_surface(file, sc), tb::measured_base(sc), tb::measured_map(sc));
    EXPECT_EQ(measured.samples, error.samples);
    EXPECT_NEAR(measured.world.rms, error.world.rms, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(scenes, scene_files,
                         testing::Values(case_of{"plane:3", "half-donut:65,65", true}, case_of{"cylinder:6,2", "text:96,48", false},
                                         case_of{"sphere:3", "sine:48,33", false}, case_of{"octahedron", "checker:40,40", false},
                                         case_of{"teapot:2", "half-donut:32,32", false}));

TEST(scene_surface, mesh_without_texture_coordinates_is_refused_by_name) {
  tb::scene_options options;
  options.mesh = "plane:1";
  options.displacement = "sine:16,16";
  const tb::scene sc = tb::make_scene(options);
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const tb::loose_mesh file = tb::read_any_obj(text, "bare.obj");
  try {
    static_cast<void>(tb::world_surface(file, sc));
    FAIL() << "not refused";
  } catch (tb::input_error const& e) {
    EXPECT_NE(std::string(e.what()).find("bare.obj: no texture coordinates"), std::string::npos);
  }
}

}  // namespace
}  // namespace relievo::test
