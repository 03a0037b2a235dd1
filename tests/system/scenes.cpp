#include "tests/system/scenes.hpp"

#include <cmath>
#include <random>

#include "tb/host/base_meshes.hpp"
#include "tb/host/read_mesh.hpp"
#include "tb/host/write_mesh.hpp"
#include "tests/support/temporary_folder.hpp"

namespace relievo::test {

namespace {

using tb::scene;
using tb::scene_options;

scene_options options(std::string const& mesh, std::string const& map, std::string const& tests = "nt,sht,vt,ct") {
  scene_options o;
  o.mesh = mesh;
  o.displacement = map;
  o.tests = tb::parse_tests(tests, "tests");
  o.view_threshold = 3.0;
  return o;
}

// At least one output vertex lies at or behind the eye plane, and at least one before it.
bool some_behind(tb::run_result const& run) {
  bool behind = false, before = false;
  for (golden::triangle_out const& t : run.triangles)
    for (golden::out_vertex const& v : t.v) (v.behind ? behind : before) = true;
  return behind && before;
}

named_scene plain(std::string const& name, scene_options const& o) {
  return {name, [o] { return tb::make_scene(o); }};
}

std::string jacksboro() { return std::string(RELIEVO_SOURCE_DIR) + "/tests/data/jacksboro_403x344.png"; }

scene_options terrain(std::string const& tests) {
  scene_options o = options("plane:8", jacksboro(), tests);
  o.sample_range = tb::sample_range{236, 1076};
  o.height_threshold = 8000.0;
  o.profile_threshold = 25.0;
  o.normal_threshold = 0.3;
  return o;
}

// Scenes on a map of any size, each axis clamped and wrapped.
void add_map_sizes(std::vector<named_scene>& list) {
  const std::vector<std::array<int, 2>> sizes = {{1, 1}, {2, 2}, {1, 37}, {37, 1}, {3, 5}, {100, 63}, {8192, 5}, {5, 8192}};
  for (auto const& [w, h] : sizes)
    for (bool wrap : {false, true}) {
      const std::string name = "map_" + std::to_string(w) + "x" + std::to_string(h) + (wrap ? "_wrap" : "_clamp");
      list.push_back({name, [w = w, h = h, wrap] {
                        scene_options o = options("plane:3", "rough map", "nt,sht,pt,vt,ct");
                        o.wrap = std::array<bool, 2>{wrap, wrap};
                        o.max_generation = 6;
                        o.scale = 0.05;
                        tb::displacement_map map = rough_map(w, h, 7);
                        map.wrap_u = map.wrap_v = wrap;
                        const glm::dvec2 samples(wrap ? w : std::max(1, w - 1), wrap ? h : std::max(1, h - 1));
                        return tb::make_scene(o, *tb::make_base_mesh(o.mesh, samples), map);
                      }});
    }
}

// One triangle with the eye so that one of its corners is at the given distance before the eye plane (0: on it, negative: behind).
scene eye_scene(double distance) {
  scene_options o = options("single triangle", "rough map", "nt,sht,pt,vt,ct");
  o.eye = glm::dvec3(0.0, 0.0, 0.5);
  o.at = glm::dvec3(1.0, 0.0, 0.5);
  o.scale = 0.0;
  o.max_generation = 5;
  o.texel_size = glm::dvec2(0.1);
  // The line of sight is +x: x is the distance before the eye.
  const tb::mesh mesh = single_triangle({distance, -0.25, 0}, {2.0, -0.5, 0}, {2.0, 0.5, 0}, {0, 0}, {1, 0}, {1, 1});
  return tb::make_scene(o, mesh, rough_map(16, 16, 3));
}

// Normals at the ends of an edge point against each other: their mean is the zero vector.
scene opposite_normals() {
  scene_options o = options("opposite normals", "rough map", "sht,pt,vt,ct");
  o.texel_size = glm::dvec2(0.1);
  tb::mesh mesh = single_triangle({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, 0}, {1, 0}, {1, 1});
  mesh.vertices[0].n = {0, 0, 1};
  mesh.vertices[1].n = {0, 0, -1};
  mesh.vertices[1].t = {-1, 0, 0};
  mesh.vertices[0].t = mesh.vertices[2].t = {1, 0, 0};
  mesh.has_tangents = true;
  o.height_threshold = 1.0;
  return tb::make_scene(o, mesh, rough_map(32, 32, 5));
}

// The output of one run as the base mesh of the next (Figure 11 c).
scene second_pass() {
  scene_options first = options("plane:3", "half-donut:64,64");
  const scene sc = tb::make_scene(first);
  const tb::run_result run = tb::run_model("golden", sc);
  const temporary_folder folder;
  const std::string path = folder.file("first_pass.ply");
  tb::write_mesh(path, run.triangles, sc);
  scene_options second = options("second pass", "checker:64,64", "nt,sht,pt,vt,ct");
  second.scale = 0.02;
  second.max_generation = 4;
  second.texel_size = glm::dvec2(2.0 / 63);
  return tb::make_scene(second, tb::read_mesh(path), *tb::generate_map("checker:64,64"));
}

std::vector<named_scene> make_list() {
  std::vector<named_scene> list;
  for (char const* map : {"half-donut", "sine", "checker", "text", "constant", "maximum", "ramp"}) {
    list.push_back(plain(std::string("plane_") + map, options("plane:3", std::string(map) + ":96,80")));
    list.push_back(plain(std::string("plane_pt_") + map, options("plane:3", std::string(map) + ":96,80", "pt,vt,ct")));
  }
  list.push_back(plain("jacksboro_paper", terrain("nt,sht,vt,ct")));
  list.push_back(plain("jacksboro_pt", terrain("pt,ct")));
  list.push_back(plain("jacksboro_all", terrain("nt,sht,pt,ht,vt,ct")));
  {
    scene_options o = terrain("nt,sht,pt,vt,ct");
    o.cull = true;
    o.eye = glm::dvec3(0.0, -1.4, 0.15);
    o.at = glm::dvec3(0.0, 0.0, 0.1);
    named_scene culled = plain("jacksboro_culled_from_within", o);
    culled.whole = false;
    culled.shows = [](tb::run_result const& run) { return run.counts.culled > 0; };
    list.push_back(culled);
    o.cull = false;
    o.fifo = true;
    list.push_back(plain("jacksboro_fifo_from_within", o));
    o.height_average = true;
    o.height_threshold = 20.0;
    list.push_back(plain("jacksboro_average", o));
  }
  list.push_back(plain("cylinder_seam", options("cylinder:8,3", "sine:90,64", "nt,sht,pt,vt,ct")));
  list.push_back(plain("cylinder_seam_donut", options("cylinder:5,2", "half-donut:64,64")));
  list.push_back(plain("sphere", options("sphere:4", "checker:64,64", "nt,sht,pt,vt,ct")));
  list.push_back(plain("teapot", options("teapot:2", "half-donut:48,48", "nt,sht,pt,vt,ct")));
  list.push_back(plain("octahedron", options("octahedron", "sine:64,64", "nt,sht,pt,ht,vt,ct")));
  list.push_back({"second_pass", second_pass});
  list.push_back({"eye_before", [] { return eye_scene(0.3); }});
  list.push_back({"eye_on", [] { return eye_scene(0.0); }, true, true, some_behind});
  list.push_back({"eye_behind", [] { return eye_scene(-1.0); }, true, true, some_behind});
  list.push_back({"tiny", [] {
                    scene_options o = options("tiny", "rough map", "nt,sht,pt,ct");
                    o.texel_size = glm::dvec2(0.1);
                    o.max_generation = 15;
                    return tb::make_scene(o,
                                          single_triangle({0, 0, 0}, {1e-3, 0, 0}, {1e-3, 1e-3, 0}, {0.4, 0.4}, {0.41, 0.4}, {0.41, 0.41}),
                                          rough_map(64, 64, 11));
                  }});
  list.push_back(
      {"sliver", [] {
         scene_options o = options("sliver", "rough map", "nt,sht,pt,vt,ct");
         o.texel_size = glm::dvec2(0.1);
         return tb::make_scene(o, single_triangle({-1, 0, 0}, {1, 0, 0}, {1, 1e-4, 0}, {0, 0}, {1, 0}, {1, 0.001}), rough_map(64, 64, 13));
       }});
  list.push_back(
      {"collinear", [] {
         scene_options o = options("collinear", "rough map", "nt,sht,pt,ct");
         o.texel_size = glm::dvec2(0.1);
         return tb::make_scene(o, single_triangle({-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0}, {0.5, 0}, {1, 0.5}), rough_map(64, 64, 17));
       }});
  list.push_back({"opposite_normals", opposite_normals, true, true, [](tb::run_result const& run) { return run.counts.zero_vectors > 0; }});
  add_map_sizes(list);
  return list;
}

}  // namespace

std::vector<named_scene> const& all_scenes() {
  static const std::vector<named_scene> list = make_list();
  return list;
}

tb::mesh single_triangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec2 ua, glm::dvec2 ub, glm::dvec2 uc) {
  tb::mesh m;
  m.name = "single triangle";
  m.vertices = {{a, {0, 0, 1}, {}, ua}, {b, {0, 0, 1}, {}, ub}, {c, {0, 0, 1}, {}, uc}};
  m.triangles = {{0, 1, 2}};
  return m;
}

tb::displacement_map rough_map(int width, int height, unsigned seed) {
  tb::displacement_map map;
  map.width = width;
  map.height = height;
  map.name = "rough map";
  std::mt19937 random(seed);
  for (int i = 0; i < width * height; ++i) {
    const double smooth = 0.5 + 0.5 * std::sin(0.07 * (i % width)) * std::cos(0.05 * static_cast<double>(i / width));
    map.texels.push_back(static_cast<std::uint16_t>(smooth * 50000.0 + static_cast<double>(random() % 12000)));
  }
  return map;
}

}  // namespace relievo::test
