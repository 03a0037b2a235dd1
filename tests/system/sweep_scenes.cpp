// Whole scenes through every model of the sweep engine: hls = golden word for word and in order, the colours too, counters equal, and what
// comes out of ideal, golden and hls is whole: no crack, no T-vertex, no flip, nothing missing but what was left out on purpose.
#include <gtest/gtest.h>

#include <cmath>

#include "golden/sweep/grid_transform.hpp"
#include "golden/sweep/z_table.hpp"
#include "tb/analysis/check_sweep.hpp"
#include "tb/host/base_meshes.hpp"
#include "tb/model/compare.hpp"
#include "tests/system/scenes.hpp"

namespace relievo::test {

namespace {

struct sweep_case {
  std::string name;
  std::function<tb::scene()> make;
  // What the scene is on the list for, where a counter shows it.
  std::function<bool(golden::sweep_counters const&)> shows = {};
};

tb::scene_options options(std::string const& mesh, std::string const& map, double grid) {
  tb::scene_options o;
  o.engine = tb::engine_kind::sweep;
  o.mesh = mesh;
  o.displacement = map;
  o.scale = 0.1;
  o.grid = grid;
  o.viewport = {640, 480};
  return o;
}
sweep_case plain(std::string const& name, tb::scene_options const& o, std::function<bool(golden::sweep_counters const&)> shows = {}) {
  return {name, [o] { return tb::make_scene(o); }, shows};
}

std::string jacksboro() { return std::string(RELIEVO_SOURCE_DIR) + "/tests/data/jacksboro_403x344.png"; }

tb::scene_options seen_from(tb::scene_options o, glm::dvec3 eye, glm::dvec3 at, double near, double far) {
  o.eye = eye;
  o.at = at;
  o.near = near;
  o.far = far;
  return o;
}

// One triangle, of which a corner lies that far before the eye plane (negative: behind).
tb::scene eye_scene(double distance) {
  tb::scene_options o = seen_from(options("single triangle", "rough map", 20), {0, 0, 0.5}, {1, 0, 0.5}, 0.1, 10);
  o.texel_size = glm::dvec2(0.1);
  const tb::mesh mesh = single_triangle({distance, -0.25, 0}, {2.0, -0.5, 0}, {2.0, 0.5, 0}, {0, 0}, {1, 0}, {1, 1});
  return tb::make_scene(o, mesh, rough_map(16, 16, 3));
}

tb::scene lone_triangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, double grid) {
  tb::scene_options o = seen_from(options("lone triangle", "rough map", grid), {0, -3, 1}, {0, 0, 0}, 1, 6);
  o.scale = 0.5;
  o.texel_size = glm::dvec2(0.1);
  return tb::make_scene(o, single_triangle(a, b, c, {0, 0}, {1, 0}, {1, 0.5}), rough_map(32, 32, 9));
}

std::vector<sweep_case> make_list() {
  const auto cut = [](golden::sweep_counters const& c) { return c.cut > 0 && c.pieces > c.triangles_in - c.outside; };
  const auto unseen = [](golden::sweep_counters const& c) { return c.unseen > 0; };
  const auto rejected = [](golden::sweep_counters const& c) { return c.rejected > 0; };
  std::vector<sweep_case> list;
  for (const double grid : {3.0, 5.0, 20.0, 45.0})
    list.push_back(plain("plane_" + std::to_string(int(grid)), options("plane:3", "half-donut:96,80", grid)));
  list.push_back(plain("grid_beyond_the_mesh", options("plane:3", "half-donut:96,80", 8191.0)));
  list.push_back(plain("grid_of_no_whole_pixels", options("plane:2", "sine:96,80", 7.3)));
  tb::scene_options terrain = options("plane:8", jacksboro(), 5.0);
  terrain.scale = 0.25;
  list.push_back(plain("jacksboro", terrain));
  terrain.grid = 20.0;
  list.push_back(plain("jacksboro_from_within", seen_from(terrain, {0, -0.9, 0.15}, {0, 0, 0.1}, 0.05, 1.2),
                       [=](golden::sweep_counters const& c) { return cut(c) && unseen(c) && rejected(c) && c.outside > 0; }));
  list.push_back(plain("cylinder_seam", options("cylinder:8,3", "sine:90,64", 10.0)));
  list.push_back(plain("cylinder_seam_of_8192", options("cylinder:5,2", "sine:8192,5", 10.0)));
  tb::scene_options inside_cylinder = seen_from(options("cylinder:16,2", "sine:90,64", 45.0), {0, 0, 0.1}, {1, 0.1, 0}, 0.1, 3);
  inside_cylinder.fov_degrees = 90;
  list.push_back(plain("within_the_cylinder", inside_cylinder, cut));
  list.push_back(plain("sphere", options("sphere:8", "checker:64,64", 10.0)));
  list.push_back(plain("sphere_of_small_triangles", options("sphere:24", "sine:64,64", 45.0)));
  list.push_back(plain("teapot", options("teapot:3", "half-donut:48,48", 8.0)));
  list.push_back(plain("octahedron", options("octahedron", "sine:64,64", 10.0)));
  list.push_back(plain("octahedron_around_the_eye", seen_from(options("octahedron", "sine:64,64", 60.0), {0, 0, 0}, {1, 0.2, 0.1}, 0.05, 4),
                       [=](golden::sweep_counters const& c) { return cut(c) && c.outside > 0; }));
  list.push_back(plain("octahedron_from_its_middle_to_a_face",
                       seen_from(options("octahedron", "sine:64,64", 60.0), {0, 0, 0}, {1, 1, 1}, 0.05, 4), cut));
  list.push_back(plain("edge_on", seen_from(options("plane:4", "sine:64,64", 8.0), {0, -3, 0}, {0, 0, 0}, 1, 6)));
  list.push_back(plain("nearly_edge_on", seen_from(options("plane:4", "sine:64,64", 8.0), {0, -3, 0.01}, {0, 0, 0}, 1, 6)));
  list.push_back({"before_the_near_plane", [] { return eye_scene(0.3); }});
  list.push_back({"through_the_near_plane", [] { return eye_scene(0.02); }, cut});
  list.push_back({"from_behind_the_eye", [] { return eye_scene(-1.0); }, cut});
  const auto point = [](golden::sweep_counters const& c) { return c.primitives == 1 && c.triangles_out == 1; };
  list.push_back({"within_a_cell", [] { return lone_triangle({0, 0, 0}, {1e-3, 0, 0}, {1e-3, 1e-3, 0}, 20); }, point});
  list.push_back({"sliver", [] { return lone_triangle({-1, 0, 0}, {1, 0, 0}, {1, 1e-4, 0}, 5); }});
  list.push_back({"collinear", [] { return lone_triangle({-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, 5); }});
  list.push_back({"two_corners_in_a_cell", [] { return lone_triangle({-1, 0, 0}, {1, 0, 0}, {1, 1e-3, 0}, 45); }});
  return list;
}

std::vector<sweep_case> const& cases() {
  static const std::vector<sweep_case> list = make_list();
  return list;
}

std::string name_of(testing::TestParamInfo<int> const& info) { return cases()[static_cast<std::size_t>(info.param)].name; }

class sweep_scene : public testing::TestWithParam<int> {};

TEST_P(sweep_scene, every_model_is_whole_and_hls_equals_golden) {
  sweep_case const& now = cases()[static_cast<std::size_t>(GetParam())];
  const tb::scene sc = now.make();
  std::vector<tb::run_result> runs;
  for (char const* model : {"ideal", "golden", "hls"}) {
    runs.push_back(tb::run_model(model, sc));
    const tb::check_report report = tb::check_sweep(runs.back(), sc.regs.map);
    EXPECT_TRUE(report.clean()) << model << "\n" << tb::to_text(report);
    EXPECT_TRUE(report.exact);
  }
  tb::run_result const &golden = runs[1], &hls = runs[2];
  ASSERT_FALSE(golden.triangles.empty());
  const tb::comparison c = tb::compare_runs("golden", golden, "hls", hls);
  EXPECT_EQ(c.words_different, 0u) << c.first_difference;
  for (std::string const& line : c.counters_different) ADD_FAILURE() << line;
  EXPECT_EQ(golden.sweep->colours, hls.sweep->colours);

  golden::sweep_counters const& counts = hls.sweep->count.counters;
  EXPECT_EQ(counts.saturations + counts.grid_saturations + counts.overflows, 0u);
  EXPECT_EQ(counts.triangles_in, sc.triangles.size());
  EXPECT_EQ(counts.triangles_out, hls.triangles.size());
  EXPECT_TRUE(hls.triangles.back().last);
  if (now.shows) {
    EXPECT_TRUE(now.shows(counts)) << "the scene no longer holds what it is on the list for";
  }
}

INSTANTIATE_TEST_SUITE_P(scenes, sweep_scene, testing::Range(0, static_cast<int>(cases().size())), name_of);

}  // namespace

// The colour of every vertex of a white mesh is white, whatever its depth.
TEST(sweep_colours, pass) {
  const tb::scene sc = cases().front().make();
  const tb::run_result run = tb::run_model("hls", sc);
  for (glm::dvec4 const& colour : run.sweep->colours) ASSERT_EQ(colour, glm::dvec4(1.0));
}

// A check that cannot fail proves nothing: a vertex moved, a triangle lost, one twice, an edge divided otherwise on one side.
TEST(sweep_check, notices) {
  const tb::scene sc = cases().front().make();
  const tb::run_result whole = tb::run_model("golden", sc);
  ASSERT_TRUE(tb::check_sweep(whole, sc.regs.map).clean());
  tb::run_result run = whole;
  run.triangles[5].v[1].displaced_p.x += 0x1p-20;
  EXPECT_GT(tb::check_sweep(run, sc.regs.map).parted, 0u);
  run = whole;
  run.triangles.erase(run.triangles.begin() + 7);
  run.sweep->piece_of.erase(run.sweep->piece_of.begin() + 7);
  EXPECT_GT(tb::check_sweep(run, sc.regs.map).missing_area, 0u) << "no engine left it out";
  run = whole;
  run.triangles.push_back(run.triangles[9]);
  run.sweep->piece_of.push_back(run.sweep->piece_of[9]);
  EXPECT_FALSE(tb::check_sweep(run, sc.regs.map).clean());
  // The first piece walked on a coarser grid than its neighbours.
  tb::scene coarse = sc;
  coarse.sweep.grid.cells_per_pixel /= 2;
  const tb::run_result other = tb::run_model("golden", coarse);
  run = whole;
  run.triangles.clear();
  run.sweep->piece_of.clear();
  for (auto const* from : {&other, &whole})
    for (std::size_t i = 0; i < from->triangles.size(); ++i) {
      const std::uint64_t piece = from->sweep->piece_of[i];
      if ((piece == 0) != (from == &other)) continue;
      run.triangles.push_back(from->triangles[i]);
      run.sweep->piece_of.push_back(piece);
    }
  run.sweep->pieces[0] = other.sweep->pieces[0];
  EXPECT_GT(tb::check_sweep(run, sc.regs.map).t_vertices, 0u);
}

// The z grid of a scene is that of the paper's example for Figure 7: far is 100 times near.
TEST(sweep_registers, figure_7) {
  tb::scene_options o = seen_from(options("plane:1", "constant:4,4", 1.0), {0, -3, 1}, {0, 0, 0}, 0.5, 50);
  o.fov_degrees = 90;
  o.viewport = {300, 300};
  const tb::scene sc = tb::make_scene(o);
  const std::vector<double> table = golden::z_table_of(sc.sweep.kappa);
  const double steps = golden::depth_cells_of(sc.sweep.far, sc.sweep.grid.octave, table) - sc.sweep.grid.near_cells;
  EXPECT_NEAR(steps, 693.1, 0.5);
}

// No vertex has a depth that the register cannot hold: a plane beyond is where the register ends.
TEST(sweep_registers, far_beyond_everything) {
  tb::scene_options o = seen_from(options("plane:2", "sine:16,16", 20.0), {0, -3, 1}, {0, 0, 0}, 0.5, 1e6);
  const tb::scene sc = tb::make_scene(o);
  EXPECT_EQ(sc.sweep.far, golden::range_of<formats::depth>::max);
  o.far = 20.0;
  const tb::run_result here = tb::run_model("golden", tb::make_scene(o)), beyond = tb::run_model("golden", sc);
  EXPECT_TRUE(tb::compare_runs("far 20", here, "far 1e6", beyond).equal());
}

}  // namespace relievo::test
