// scene: conversions between the user's units and the registers, what is shared after quantisation, and what is refused.
#include "tb/host/scene.hpp"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "golden/core/rounding.hpp"
#include "tb/host/base_meshes.hpp"
#include "tests/support/refuses.hpp"

namespace relievo::test {
namespace {

tb::scene_options over(std::string const& mesh, std::string const& displacement) {
  tb::scene_options o;
  o.mesh = mesh;
  o.displacement = displacement;
  return o;
}

template <class F>
bool is_word(double x) {
  return golden::rounded::at<F>(x) == x;
}

// Every register and vertex field is a value of its format.
void expect_quantised(tb::scene const& sc) {
  for (auto const& t : sc.triangles) {
    for (auto const& v : t.v) {
      for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(is_word<formats::position>(v.p[i]));
        EXPECT_TRUE(is_word<formats::unit>(v.n[i]));
        EXPECT_TRUE(is_word<formats::unit>(v.t[i]));
        EXPECT_LE(std::abs(v.p[i]), 7.5);
      }
      EXPECT_TRUE(is_word<formats::coordinate>(v.u.x) && is_word<formats::coordinate>(v.u.y));
      EXPECT_LE(v.u.x, sc.texels_per_unit().x);
      EXPECT_LE(v.u.y, sc.texels_per_unit().y);
    }
  }
  EXPECT_TRUE(is_word<formats::scale>(sc.regs.displace.scale));
  EXPECT_TRUE(is_word<formats::height>(sc.regs.displace.bias));
  EXPECT_TRUE(is_word<formats::gradient>(sc.normal_map.gradient_u));
  EXPECT_TRUE(is_word<formats::gradient>(sc.normal_map.gradient_v));
  EXPECT_TRUE(sc.triangles.back().last);
}

TEST(scene, every_mesh_with_every_address_mode_is_quantised) {
  for (char const* mesh : {"plane:3", "cylinder:5,2", "sphere:4", "octahedron", "teapot:1", "teapot:2", "teapot:4"}) {
    for (std::array<bool, 2> wrap : {std::array{false, false}, {true, false}, {true, true}}) {
      tb::scene_options o = over(mesh, "half-donut:37,21");
      o.wrap = wrap;
      const tb::scene sc = tb::make_scene(o);
      expect_quantised(sc);
      EXPECT_EQ(sc.regs.map.wrap_u, wrap[0]);
    }
  }
}

TEST(scene, plane_spans_the_map) {
  tb::scene sc = tb::make_scene(over("plane:4", "ramp:403,344"));
  EXPECT_EQ(sc.triangles.front().v[0].u, glm::dvec2(0, 0));
  EXPECT_EQ(sc.triangles.back().v[1].u, glm::dvec2(402, 343));
  EXPECT_NEAR(sc.texel_size.x, 2.0 / 402, 1e-12);
  EXPECT_NEAR(sc.texel_size.y, 2.0 / 402, 1e-12);
  tb::scene_options o = over("plane:4", "ramp:403,344");
  o.wrap = {{true, true}};
  sc = tb::make_scene(o);
  EXPECT_EQ(sc.triangles.back().v[1].u, glm::dvec2(403, 344));
  EXPECT_NEAR(sc.base.vertices.back().p.y, 344.0 / 403, 1e-12);
}

TEST(scene, maps_of_every_size_work) {
  for (char const* size : {"1,1", "2,2", "1,9", "9,1", "5,3", "8192,2", "2,8192"}) {
    for (bool wrap : {false, true}) {
      tb::scene_options o = over("plane:2", std::string("sine:") + size);
      o.wrap = {{wrap, wrap}};
      expect_quantised(tb::make_scene(o));
    }
  }
}

TEST(scene, displacement_is_bias_plus_scale_times_the_part) {
  tb::scene_options o = over("plane:2", "maximum:4");
  o.scale = 0.75;
  o.bias = -0.5;
  const tb::scene sc = tb::make_scene(o);
  EXPECT_NEAR((sc.regs.displace.scale * 65535 + sc.regs.displace.bias) / sc.world_scale, 0.25, 2e-6);
  EXPECT_EQ(sc.to_world(sc.from_world({0.1, 0.2, 0.3})), glm::dvec3(0.1, 0.2, 0.3));
}

TEST(scene, world_scale_is_the_largest_power_of_two_that_fits) {
  tb::scene_options o = over("plane:2", "maximum:4");
  o.scale = 0.25;
  EXPECT_EQ(tb::make_scene(o).world_scale, 4.0);
  o.scale = 3.0;
  EXPECT_EQ(tb::make_scene(o).world_scale, 2.0);
  o.scale = 30.0;
  EXPECT_EQ(tb::make_scene(o).world_scale, 0.25);
  o = over("sphere:2", "maximum:4");
  EXPECT_EQ(tb::make_scene(o).world_scale, 4.0);
  EXPECT_EQ(tb::make_scene(o).centre, glm::dvec3(0));
}

TEST(scene, a_mesh_far_off_gets_a_centre) {
  const tb::scene_options o = over("far.obj", "constant:4");
  tb::mesh m = *tb::make_base_mesh("plane:2", glm::dvec2(1));
  for (auto& v : m.vertices) v.p += glm::dvec3(500000, 4000000, 300);
  const tb::scene sc = tb::make_scene(o, m, *tb::generate_map("constant:4"));
  EXPECT_GE(sc.world_scale, 2.0);
  EXPECT_EQ(sc.to_world(sc.triangles.front().v[0].p), m.vertices.front().p);
  expect_quantised(sc);
}

TEST(scene, seams_share_their_bits) {
  using key = std::tuple<double, double, double, double>;
  for (bool generated : {true, false}) {
    tb::mesh m = *tb::make_base_mesh("cylinder:7,3", glm::dvec2(1));
    m.has_tangents = generated;
    tb::scene_options o = over("cylinder:7,3", "sine:50,40");
    const tb::scene sc = tb::make_scene(o, m, *tb::generate_map("sine:50,40"));
    std::map<key, golden::vertex> at;
    int shared = 0;
    for (auto const& t : sc.triangles) {
      for (auto const& v : t.v) {
        const auto [found, added] = at.emplace(key{v.p.x, v.p.y, v.p.z, v.u.x == 50 ? 0 : v.u.x}, v);
        if (added) continue;
        ++shared;
        EXPECT_EQ(found->second.n, v.n);
        EXPECT_EQ(found->second.t, v.t);
        EXPECT_EQ(found->second.u.y, v.u.y);
      }
    }
    EXPECT_EQ(at.size(), 7u * 4u);
    EXPECT_EQ(shared, 7 * 3 * 6 - 7 * 4);
  }
}

TEST(scene, tangents_follow_u_and_are_orthogonal) {
  for (char const* mesh : {"plane:2", "cylinder:6,2", "sphere:4", "octahedron"}) {
    tb::mesh m = *tb::make_base_mesh(mesh, glm::dvec2(1));
    tb::mesh given = m;
    m.has_tangents = false;
    const tb::scene sc = tb::make_scene(over(mesh, "sine:50,40"), m, *tb::generate_map("sine:50,40"));
    for (std::size_t i = 0; i < m.vertices.size(); ++i) {
      EXPECT_NEAR(glm::length(sc.base.vertices[i].t), 1, 1e-9);
      EXPECT_NEAR(glm::dot(sc.base.vertices[i].t, sc.base.vertices[i].n), 0, 1e-9);
      // The diagonals of the sphere's quads pull a little to one side; at the poles there is a single triangle.
      if (given.has_tangents && std::abs(m.vertices[i].n.z) < 1.0 - 1e-9) {
        EXPECT_GT(glm::dot(sc.base.vertices[i].t, given.vertices[i].t), 0.99) << mesh << i;
      }
    }
  }
}

TEST(scene, mirrored_parametrisations_are_refused) {
  tb::mesh m = *tb::make_base_mesh("plane:2", glm::dvec2(1));
  m.has_tangents = false;
  for (auto& v : m.vertices) v.u.x = 1 - v.u.x;
  const auto making = [&] { tb::make_scene(over("m.obj", "sine"), m, *tb::generate_map("sine")); };
  EXPECT_TRUE(refuses(making, {"plane:2", "triangle 0", "mirrored"}));
}

TEST(scene, half_a_mirrored_piece_is_refused_and_a_fold_is_not) {
  tb::mesh m = *tb::make_base_mesh("plane:4", glm::dvec2(1));
  m.has_tangents = false;
  tb::mesh half = m;
  // u grows to the middle and falls again, as when one half of a picture serves both halves of a face.
  for (auto& v : half.vertices) v.u.x = 1 - std::abs(2 * v.u.x - 1);
  EXPECT_TRUE(refuses([&] { tb::make_scene(over("m.obj", "sine"), half, *tb::generate_map("sine")); }, {"plane:4", "mirrored"}));
  // One inner vertex pulled across its neighbour turns a few triangles over.
  m.vertices[12].p.x = 0.75;
  EXPECT_NO_THROW(tb::make_scene(over("m.obj", "sine"), m, *tb::generate_map("sine")));
}

TEST(scene, coordinates_outside_the_map_are_refused) {
  for (double off : {-0.01, 1.01}) {
    tb::mesh m = *tb::make_base_mesh("plane:2", glm::dvec2(1));
    m.vertices[4].u.y = off;
    EXPECT_TRUE(refuses([&] { tb::make_scene(over("m.obj", "sine"), m, *tb::generate_map("sine")); }, {"vertex 4", "v = ", "0 to 1"}));
  }
  tb::mesh m = *tb::make_base_mesh("plane:2", glm::dvec2(1));
  m.vertices.back().u = glm::dvec2(1.0000001, 1.0000001);
  EXPECT_NO_THROW(tb::make_scene(over("m.obj", "sine"), m, *tb::generate_map("sine")));
}

TEST(scene, warns_where_positions_agree_and_normals_do_not) {
  tb::mesh m = *tb::make_base_mesh("cylinder:7,1", glm::dvec2(1));
  tb::scene_options o = over("cylinder:7,1", "sine");
  EXPECT_TRUE(tb::make_scene(o, m, *tb::generate_map("sine")).warnings.empty());
  m.vertices[0].n = glm::normalize(glm::dvec3(1, 0, 0.1));
  const auto warnings = tb::make_scene(o, m, *tb::generate_map("sine")).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("normal"), std::string::npos);
  EXPECT_TRUE(tb::make_scene(over("octahedron", "sine")).warnings.empty());
  EXPECT_TRUE(tb::make_scene(over("sphere", "sine")).warnings.empty());
}

TEST(scene, thresholds_are_converted_from_the_users_units) {
  tb::scene_options o = over("plane:2", "ramp:16");
  o.normal_threshold = 0.25;
  o.height_threshold = 840.0;
  o.profile_threshold = 84.0;
  o.view_threshold = 2.5;
  tb::scene sc = tb::make_scene(o);
  EXPECT_EQ(sc.regs.normal.threshold, 0.25);
  EXPECT_EQ(sc.regs.summed_height.sum_threshold, 840.0);
  EXPECT_EQ(sc.regs.summed_height.average_threshold, 0.0);
  EXPECT_EQ(sc.regs.profile.threshold, 84.0);
  EXPECT_EQ(sc.regs.view.threshold, 2.5);
  o.sample_range = tb::sample_range{236, 1076};
  o.height_average = true;
  sc = tb::make_scene(o);
  EXPECT_EQ(sc.regs.summed_height.average_threshold, 65535.0);
  EXPECT_EQ(sc.regs.profile.threshold, 6553.5);
  EXPECT_DOUBLE_EQ(sc.physical(65535), 1076.0);
  EXPECT_DOUBLE_EQ(sc.physical_per_sample(), 840.0 / 65535);
}

TEST(scene, the_default_generation_limit_is_from_the_longest_edge) {
  const auto generations = [](char const* mesh, char const* map) { return *tb::make_scene(over(mesh, map)).options.max_generation; };
  EXPECT_EQ(generations("plane:8", "sine:403,344"), 7);  // 50.25 texels: 6 halvings, and one
  EXPECT_EQ(generations("plane:1", "sine:257,257"), 9);
  EXPECT_EQ(generations("plane:1", "sine:8192,2"), 14);
  EXPECT_EQ(generations("plane:1", "sine:1,1"), 1);
}

TEST(scene, normal_shift_is_the_smallest_that_fits_the_steepest_slope) {
  tb::scene_options o = over("plane:1", "checker:256");
  o.scale = 0.001;
  EXPECT_EQ(tb::make_scene(o).normal_map.normal_shift, 0);
  for (double scale : {0.5, 2.0, 7.0}) {
    o.scale = scale;
    const tb::scene sc = tb::make_scene(o);
    const int shift = static_cast<int>(sc.normal_map.normal_shift);
    const double slope = scale * 255 / 4;  // one sample step over two texels of 2/255
    EXPECT_LE(slope / std::ldexp(1.0, shift), 8.0);
    EXPECT_GT(slope / std::ldexp(1.0, shift - 1), 8.0 - 0.01);
    EXPECT_NEAR(sc.normal_map.gradient_u * std::ldexp(1.0, shift), scale / 65535 * 255 / 4, std::ldexp(1.0, shift - 22));
  }
}

TEST(scene, values_that_fit_no_register_are_refused_by_the_options_name) {
  const auto making = [](auto change) {
    tb::scene_options o = over("plane:2", "half-donut:64");
    change(o);
    return [o] { tb::make_scene(o); };
  };
  using options = tb::scene_options;
  EXPECT_TRUE(refuses(making([](options& o) { o.normal_threshold = 5; }), {"--normal-threshold", "5"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.normal_threshold = -1; }), {"--normal-threshold", "from 0"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.height_threshold = 2e12; }), {"--height-threshold"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.profile_threshold = 70000; }), {"--profile-threshold", "65535"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.view_threshold = NAN; }), {"--view-threshold"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.highlight_threshold = 3; }), {"--highlight-threshold"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.half_vector = glm::dvec3(0); }), {"--half-vector"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.max_generation = 16; }), {"--max-generation", "15"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.texel_size = glm::dvec2(0, 1); }), {"--texel-size"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.texel_size = glm::dvec2(1e-12, 1); }), {"--texel-size", "slope"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.scale = INFINITY; }), {"--scale"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.eye = glm::dvec3(1000, 0, 0); }), {"--eye", "too far"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.sample_range = tb::sample_range{3, 3}; }), {"--sample-range"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.mesh = "cube"; }), {"cube", ".obj, .ply or .glb"}));
  EXPECT_TRUE(refuses(making([](options& o) { o.displacement = "bumps"; }), {"bumps", ".png, .pgm or .exr"}));
}

TEST(scene, a_mesh_without_area_needs_a_texel_size) {
  tb::mesh m;
  m.name = "line.obj";
  for (double x : {0.0, 0.5, 1.0}) m.vertices.push_back({{x, 0, 0}, {0, 0, 1}, {}, {x, 0}});
  m.triangles = {{0, 1, 2}};
  tb::scene_options o = over("line.obj", "sine:16");
  EXPECT_TRUE(refuses([&] { tb::make_scene(o, m, *tb::generate_map("sine:16")); }, {"line.obj", "--texel-size"}));
  o.texel_size = glm::dvec2(0.1, 0.1);
  expect_quantised(tb::make_scene(o, m, *tb::generate_map("sine:16")));
}

}  // namespace
}  // namespace relievo::test
