#include "tb/commands/scene_arguments.hpp"

#include <cstdio>

#include "tb/host/input_error.hpp"

namespace relievo::tb {

void scene_arguments::add_to(CLI::App& app) {
  auto* engine = app.add_option("--engine", engine_, "engine: edge|sweep");
  engine->group("Scene")->capture_default_str();
  app.add_option("--mesh", options_.mesh, "FILE.obj|.ply|.glb, or plane[:N], cylinder[:N,M], sphere[:N], teapot[:N], octahedron")
      ->group("Scene")
      ->capture_default_str();
  app.add_option("--displacement", options_.displacement,
                 "FILE.png|.pgm|.exr, or half-donut, sine, checker, text, constant, maximum, ramp, each [:W,H]")
      ->group("Scene")
      ->capture_default_str();
  app.add_option("--scale", options_.scale, "displacement of a full-scale sample, world units")->group("Scene")->capture_default_str();
  app.add_option("--bias", options_.bias, "displacement of sample 0, world units")->group("Scene")->capture_default_str();
  app.add_option("--sample-range", sample_range_, "LO,HI: what the samples 0 and 65535 mean (metres); thresholds and reports use it")
      ->group("Scene");
  app.add_option("--texel-size", texel_size_, "DU,DV: world units per texel; default: measured on the mesh")->group("Scene");
  app.add_option("--address", address_, "clamp|wrap[,clamp|wrap] beyond the map's borders in u, v")->group("Scene");
  app.add_option("--eye", eye_, "x,y,z; default: sees everything from a slant")->group("Camera");
  app.add_option("--at", at_, "x,y,z")->group("Camera");
  app.add_option("--up", up_, "x,y,z")->group("Camera");
  app.add_option("--fov", options_.fov_degrees, "vertical field of view, degrees")->group("Camera")->capture_default_str();
  app.add_option("--near", near_, "near plane (edge: for reports and the rasteriser)")->group("Camera");
  app.add_option("--far", far_, "far plane (likewise)")->group("Camera");
  app.add_option("--viewport", viewport_, "WxH pixels")->group("Camera");
  const auto of_edge = [this](CLI::Option* o) { edge_options_.push_back(o->group("Edge engine")); };
  of_edge(app.add_option("--tests", tests_, "which of nt,sht,pt,ht,vt,ct are on, or none; default nt,sht,vt,ct"));
  of_edge(app.add_option("--normal-threshold", options_.normal_threshold, "nt: difference of components of unit normals")
              ->capture_default_str());
  of_edge(app.add_option("--height-threshold", height_threshold_, "sht: samples (units of the range), times texels in sum mode"));
  of_edge(app.add_option("--height-mode", height_mode_, "sht: sum|average"));
  of_edge(app.add_option("--profile-threshold", profile_threshold_, "pt: samples (units of the range)"));
  of_edge(app.add_option("--highlight-threshold", options_.highlight_threshold, "ht: cosine")->capture_default_str());
  of_edge(app.add_option("--half-vector", half_vector_, "ht: x,y,z"));
  of_edge(app.add_option("--view-threshold", options_.view_threshold, "vt: pixels, Manhattan")->capture_default_str());
  of_edge(app.add_option("--max-generation", max_generation_, "0..15; default ceil(log2(longest base edge in texels)) + 1"));
  of_edge(app.add_option("--queue", queue_, "lifo|fifo"));
  of_edge(app.add_flag("--cull", options_.cull, "drop triangles whose displaced normals all point away from the eye"));
  auto* grid = app.add_option("--grid,--grid-size", options_.grid, "size of a cell of the grid, pixels")
                   ->group("Sweep engine")
                   ->capture_default_str();
  sweep_options_.push_back(grid);
}

void scene_arguments::add_base_triangle(CLI::App& app) {
  app.add_option("--base-triangle", base_triangle_, "N: this base triangle alone, counted from 0, with the registers of the whole scene")
      ->group("Scene");
}

void scene_arguments::check_measure(bool measure) const {
  if (measure && base_triangle_) throw input_error("--measure-error: measures the surface of the whole mesh; leave out --base-triangle");
}

scene_options scene_arguments::options() const {
  scene_options o = options_;
  o.engine = parse_engine(engine_, "--engine");
  for (CLI::Option const* option : o.engine == engine_kind::edge ? sweep_options_ : edge_options_)
    if (option->count() > 0)
      throw input_error(option->get_name() + ": is no option of the engine " + engine_ + "; leave it out, or take --engine " +
                        (o.engine == engine_kind::edge ? "sweep" : "edge"));
  if (sample_range_) o.sample_range = parse_sample_range(*sample_range_, "--sample-range");
  if (texel_size_) o.texel_size = parse_vector2(*texel_size_, "--texel-size");
  if (address_) o.wrap = parse_address(*address_, "--address");
  if (eye_) o.eye = parse_vector3(*eye_, "--eye");
  if (at_) o.at = parse_vector3(*at_, "--at");
  if (up_) o.up = parse_vector3(*up_, "--up");
  if (viewport_) o.viewport = parse_viewport(*viewport_, "--viewport");
  if (tests_) o.tests = parse_tests(*tests_, "--tests");
  if (height_mode_) o.height_average = parse_height_mode(*height_mode_, "--height-mode");
  if (half_vector_) o.half_vector = parse_vector3(*half_vector_, "--half-vector");
  if (queue_) o.fifo = parse_queue(*queue_, "--queue");
  o.near = near_;
  o.far = far_;
  o.height_threshold = height_threshold_;
  o.profile_threshold = profile_threshold_;
  o.max_generation = max_generation_;
  o.base_triangle = base_triangle_;
  return o;
}

scene scene_arguments::make() const {
  scene sc = make_scene(options());
  for (std::string const& line : sc.warnings) std::fprintf(stderr, "relievo: warning: %s\n", line.c_str());
  return sc;
}

}  // namespace relievo::tb
