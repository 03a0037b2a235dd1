#include "tb/commands/reporting.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "tb/analysis/image.hpp"
#include "tb/analysis/progress.hpp"
#include "tb/analysis/scene_surface.hpp"
#include "tb/host/files.hpp"
#include "tb/host/input_error.hpp"
#include "tb/host/write_mesh.hpp"

namespace relievo::tb {

void output_arguments::add_to(CLI::App& app) {
  app.add_option("-o,--output", meshes, "OUT.obj|.ply|.glb, may be given more than once")->group("Output");
  app.add_flag("--raw", raw, "the raw words too (.ply)")->group("Output");
  app.add_option("--report", report, "OUT.json")->group("Output");
  app.add_option("--image", image, "OUT.png, a shaded picture")->group("Output");
  app.add_flag("--wireframe", wireframe, "edges over the shading")->group("Output");
  app.add_flag("--measure-error", measure, "measure the error at every sample of the map")->group("Output");
}

void output_arguments::check(std::string const& model, std::vector<std::string> const& more) const {
  std::vector<std::string> paths = meshes;
  for (std::string const& path : meshes) check_mesh_path(path);
  if (!image.empty()) {
    if (extension_of(image) != "png") throw input_error(image + ": a picture's extension has to be .png");
    paths.push_back(image);
  }
  if (wireframe && image.empty()) throw input_error("--wireframe: draws on a picture; name one with --image OUT.png");
  if (!report.empty()) paths.push_back(report);
  for (std::string const& path : more)
    if (!path.empty()) paths.push_back(path);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    check_writable(paths[i]);
    if (std::find(paths.begin(), paths.begin() + static_cast<std::ptrdiff_t>(i), paths[i]) !=
        paths.begin() + static_cast<std::ptrdiff_t>(i))
      throw input_error(paths[i] + ": is named as an output twice");
  }
  if (!raw) return;
  if (std::none_of(meshes.begin(), meshes.end(), [](std::string const& path) { return extension_of(path) == "ply"; }))
    throw input_error("--raw: raw words go into .ply files; an output -o OUT.ply is needed");
  if (model == "ideal") throw input_error("--raw: the ideal model's output has no raw words; take golden or hls");
}

nlohmann::json counts_json(run_result const& run) {
  nlohmann::json json;
  const auto add = [&](char const* name, auto const& x) { json[name] = x; };
  if (!run.sweep) {
    run.counts.each_field(add);
    return json;
  }
  run.sweep->count.counters.each_field(add);
  if (run.sweep->count.additions) json["additions"] = *run.sweep->count.additions;
  return json;
}

namespace {

nlohmann::json vector_json(glm::dvec3 const& v) { return nlohmann::json::array({v.x, v.y, v.z}); }

void add_edge_options(nlohmann::json& json, scene_options const& o) {
  std::string tests;
  const auto add = [&](bool on, char const* name) { tests += on ? (tests.empty() ? "" : ",") + std::string(name) : ""; };
  add(o.tests.nt, "nt");
  add(o.tests.sht, "sht");
  add(o.tests.pt, "pt");
  add(o.tests.ht, "ht");
  add(o.tests.vt, "vt");
  add(o.tests.ct, "ct");
  json["tests"] = tests;
  json["normal_threshold"] = o.normal_threshold;
  json["height_mode"] = o.height_average ? "average" : "sum";
  json["highlight_threshold"] = o.highlight_threshold;
  json["view_threshold"] = o.view_threshold;
  json["queue"] = o.fifo ? "fifo" : "lifo";
  json["cull"] = o.cull;
  if (o.height_threshold) json["height_threshold"] = *o.height_threshold;
  if (o.profile_threshold) json["profile_threshold"] = *o.profile_threshold;
  if (o.half_vector) json["half_vector"] = vector_json(*o.half_vector);
  if (o.max_generation) json["max_generation"] = *o.max_generation;
}

}  // namespace

nlohmann::json to_json(scene const& sc) {
  scene_options const& o = sc.options;
  nlohmann::json json = {
      {"engine", o.engine == engine_kind::edge ? "edge" : "sweep"},
      {"mesh", o.mesh},
      {"eye", vector_json(sc.camera.eye)},
      {"at", vector_json(sc.camera.at)},
      {"up", vector_json(sc.camera.up)},
      {"fov", sc.camera.fov_degrees},
      {"viewport", {sc.camera.width, sc.camera.height}},
      {"displacement", o.displacement},
      {"map", {{"width", sc.map.width}, {"height", sc.map.height}, {"wrap_u", sc.map.wrap_u}, {"wrap_v", sc.map.wrap_v}}},
      {"scale", o.scale},
      {"bias", o.bias},
      {"texel_size", {sc.texel_size.x, sc.texel_size.y}},
      {"engine_units_per_world_unit", sc.world_scale}};
  if (o.engine == engine_kind::edge)
    add_edge_options(json, o);
  else
    json["grid"] = o.grid;
  if (o.near) json["near"] = *o.near;
  if (o.far) json["far"] = *o.far;
  if (sc.map.range) json["sample_range"] = {sc.map.range->low, sc.map.range->high};
  if (!sc.warnings.empty()) json["warnings"] = sc.warnings;
  return json;
}

measured_error measure(std::vector<golden::triangle_out> const& triangles, scene const& sc) {
  measured_error result;
  result.mesh = measure_error(triangles, sc);
  if (result.mesh.along_normal) result.uniform = uniform_grid_error(measured_map(sc), triangles.size());
  return result;
}

nlohmann::json to_json(measured_error const& error) {
  nlohmann::json json = {{"mesh", to_json(error.mesh)}};
  if (error.uniform) json["uniform_grid"] = to_json(*error.uniform);
  return json;
}

void write_outputs(output_arguments const& out, run_result const& run, scene const& sc) {
  for (std::string const& path : out.meshes) write_mesh(path, run.triangles, sc, out.raw && extension_of(path) == "ply");
  if (out.image.empty()) return;
  image_options options;
  options.wireframe = out.wireframe;
  write_image(out.image, world_surface(run.triangles, sc), sc.camera, options);
}

void write_report(output_arguments const& out, nlohmann::json const& report) {
  // A file's name need not be UTF-8.
  if (!out.report.empty()) write_bytes(out.report, report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void print_row(std::string const& label, std::string const& value) { std::printf("  %-22s %s\n", label.c_str(), value.c_str()); }

std::string grouped(std::uint64_t n) {
  std::string text = std::to_string(n);
  for (int i = static_cast<int>(text.size()) - 3; i > 0; i -= 3) text.insert(static_cast<std::size_t>(i), ",");
  return text;
}

namespace {
std::string figures(error_report const& e, scene const& sc) {
  char line[120];
  if (sc.map.range)
    std::snprintf(line, sizeof line, "RMS %.2f m, maximum %.1f m", e.physical.rms, e.physical.max);
  else
    std::snprintf(line, sizeof line, "RMS %.6f, maximum %.6f world units", e.world.rms, e.world.max);
  return line;
}
}  // namespace

namespace {

void print_edge(golden::counters const& c) {
  char saved[80];
  const double met = static_cast<double>(c.edge_tests + c.settled_skips);
  std::snprintf(saved, sizeof saved, ", %.1f %% saved by settled edges",
                met > 0 ? 100.0 * static_cast<double>(c.settled_skips) / met : 0.0);
  print_row("edge tests", grouped(c.edge_tests) + saved);
  print_row("queue", grouped(c.queue_high_water) + " entries at most");
}

std::string ratio_text(std::uint64_t x, std::uint64_t y) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f", static_cast<double>(x) / static_cast<double>(y));
  return text;
}

void print_sweep(sweep_count const& count) {
  golden::sweep_counters const& c = count.counters;
  if (c.cut != 0 || c.outside != 0 || c.rejected != 0)
    print_row("clipped", grouped(c.outside) + " outside, " + grouped(c.cut) + " cut, " + grouped(c.pieces) + " pieces, " +
                             grouped(c.rejected) + " of them rejected");
  print_row("primitives", grouped(c.primitives) + ", " + grouped(c.quads) + " of them quads");
  print_row("vertices", grouped(c.vertices) + (c.primitives != 0 ? ", " + ratio_text(c.vertices, c.primitives) + " a primitive" : ""));
  if (count.additions && c.quads != 0)
    print_row("additions", grouped(*count.additions) + ", " + ratio_text(*count.additions, c.quads) + " a quad");
  if (c.unseen != 0) print_row("unseen", grouped(c.unseen) + " displaced triangles left out");
  if (c.grid_saturations != 0 || c.overflows != 0)
    print_row("grid", grouped(c.grid_saturations) + " saturations, " + grouped(c.overflows) + " polygons with a vertex too many");
}

}  // namespace

void print_run(run_result const& run, scene const& sc, std::optional<measured_error> const& error) {
  golden::counters const& c = run.counts;
  print_row("triangles", grouped(c.triangles_in) + " in, " + grouped(c.triangles_out) + " out" +
                             (c.culled != 0 ? ", " + grouped(c.culled) + " culled" : ""));
  if (error) {
    print_row("error", figures(error->mesh, sc));
    if (error->uniform)
      print_row("uniform grid", figures(error->uniform->error, sc) + " with " + grouped(error->uniform->triangles) + " triangles");
  }
  if (run.sweep)
    print_sweep(run.sweep->count);
  else
    print_edge(c);
  if (c.saturations != 0 || c.screen_saturations != 0 || c.zero_vectors != 0)
    print_row("counted", grouped(c.saturations) + " saturations, " + grouped(c.screen_saturations) + " screen saturations, " +
                             grouped(c.zero_vectors) + " zero vectors");
}

std::function<void(std::size_t)> progress_hook(std::string const& label, scene const& sc) {
  const auto bar = std::make_shared<progress>(label, sc.triangles.size());
  return [bar](std::size_t begun) { bar->set(begun); };
}

}  // namespace relievo::tb
