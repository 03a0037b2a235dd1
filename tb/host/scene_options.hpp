// scene_options: what a user says about a scene and its engine, in the user's units, and how its texts are read.
// An empty optional means "choose a sensible value": make_scene fills it in and leaves the resolved options in the scene.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "tb/host/map.hpp"

namespace relievo::tb {

struct test_selection {
  bool nt = true, sht = true, pt = false, ht = false, vt = true, ct = true;
};

enum class engine_kind { edge, sweep };

struct scene_options {
  engine_kind engine = engine_kind::edge;
  std::string mesh = "plane";               // a file or a generator's name (base_meshes.hpp)
  std::string displacement = "half-donut";  // likewise (map.hpp)
  double scale = 0.25, bias = 0.0;          // displacement in world units = bias + scale * sample / 65535
  std::optional<relievo::tb::sample_range> sample_range;
  std::optional<glm::dvec2> texel_size;     // world units per texel along u and v; default: measured on the mesh
  std::optional<std::array<bool, 2>> wrap;  // per axis; default: wrap in u for cylinder and sphere, clamp otherwise

  std::optional<glm::dvec3> eye, at;  // world units; default: from a slant, so that everything is seen
  glm::dvec3 up{0.0, 0.0, 1.0};
  double fov_degrees = 40.0;
  std::optional<double> near, far;
  std::array<int, 2> viewport{1280, 720};

  test_selection tests;                    // default: the paper's four
  double normal_threshold = 0.1;           // difference of components of unit normals
  bool height_average = false;             // --height-mode average
  std::optional<double> height_threshold;  // samples (units of the sample range when given), times texels in sum mode; default 1/100 of the
                                           // range that the map's samples span (sum mode: times 64 texels)
  std::optional<double> profile_threshold;  // samples (units of the sample range); default 1/100 of the map's span
  double highlight_threshold = 0.95;        // cosine
  std::optional<glm::dvec3> half_vector;    // default: half-way between the eye's direction and a light 45 degrees above it
  double view_threshold = 4.0;              // pixels, Manhattan
  std::optional<int> max_generation;        // default ceil(log2(longest base edge in texels)) + 1, at most 15
  bool fifo = false;
  bool cull = false;

  double grid = 1.0;  // size of a cell of the sweep engine's grid, pixels

  std::optional<int> base_triangle;  // this one alone goes into the models, with the registers of the whole mesh
};

// Texts of the command line; `option` stands in the message of the input_error.
engine_kind parse_engine(std::string const& text, std::string const& option);           // edge|sweep
test_selection parse_tests(std::string const& text, std::string const& option);         // nt,sht,pt,ht,vt,ct in any order, or none
std::array<bool, 2> parse_address(std::string const& text, std::string const& option);  // clamp|wrap[,clamp|wrap]
glm::dvec3 parse_vector3(std::string const& text, std::string const& option);           // x,y,z
glm::dvec2 parse_vector2(std::string const& text, std::string const& option);           // a,b
std::array<int, 2> parse_viewport(std::string const& text, std::string const& option);  // WxH
relievo::tb::sample_range parse_sample_range(std::string const& text, std::string const& option);  // LO,HI
bool parse_height_mode(std::string const& text, std::string const& option);                        // sum|average, true for average
bool parse_queue(std::string const& text, std::string const& option);                              // lifo|fifo, true for fifo

}  // namespace relievo::tb
