// relievo error: how far a mesh, from a file of ours, is from the fully sampled displaced surface of a scene.
#include <cstdio>
#include <memory>

#include "tb/commands/commands.hpp"
#include "tb/commands/reporting.hpp"
#include "tb/commands/scene_arguments.hpp"
#include "tb/host/input_error.hpp"
#include "tb/host/read_mesh.hpp"

namespace relievo::tb {

namespace {

surface read_surface(std::string const& path, scene const& sc) {
  const loose_mesh loose = read_any_mesh(path);
  if (!loose.has_coordinates)
    throw input_error(path +
                      ": no texture coordinates; error needs them to know which sample a point belongs to (vt in .obj, s t in .ply)");
  mesh const& m = loose.m;
  surface out;
  out.reserve(m.triangles.size());
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    surface_triangle t;
    for (std::size_t j = 0; j < 3; ++j) {
      base_vertex const& v = m.vertices[m.triangles[i][j]];
      t.v[j] = {v.p, v.n, sc.to_texels(v.u)};
    }
    t.index = i < m.base_triangle.size() ? m.base_triangle[i] : 0;
    out.push_back(t);
  }
  return out;
}

void print_figures(char const* what, error_figures const& f) {
  char line[120];
  std::snprintf(line, sizeof line, "RMS %.6g, maximum %.6g, mean %.6g", f.rms, f.max, f.mean);
  print_row(what, line);
}

}  // namespace

command add_error(CLI::App& app) {
  struct arguments {
    scene_arguments scene;
    std::string mesh, report;
  };
  const auto a = std::make_shared<arguments>();
  app.add_option("MESH", a->mesh, "the tessellated mesh, .obj|.ply|.glb")->required();
  a->scene.add_to(app);
  app.add_option("--report", a->report, "OUT.json")->group("Output");
  app.footer("Example: relievo error donut.ply --mesh plane:8 --displacement half-donut");
  return [a] {
    const scene sc = a->scene.make();
    const surface displaced = read_surface(a->mesh, sc);
    const height_map heights = heights_of(sc);
    measured_error error;
    error.mesh = measure_error(displaced, base_of(sc), heights);
    if (error.mesh.along_normal) error.uniform = uniform_grid_error(heights, displaced.size());
    print_row("triangles", grouped(displaced.size()));
    print_row("samples", grouped(error.mesh.samples) + (error.mesh.along_normal ? ", along the base normal" : ", distance"));
    print_figures("world units", error.mesh.world);
    print_figures("samples", error.mesh.in_samples);
    if (sc.map.range) print_figures("units of the range", error.mesh.physical);
    if (error.uniform) {
      print_row("uniform grid", grouped(error.uniform->triangles) + " triangles");
      print_figures(sc.map.range ? "  units of the range" : "  world units",
                    sc.map.range ? error.uniform->error.physical : error.uniform->error.world);
    }
    output_arguments out;
    out.report = a->report;
    write_report(out, {{"triangles", displaced.size()}, {"error", to_json(error)}, {"scene", to_json(sc)}});
    return 0;
  };
}

}  // namespace relievo::tb
