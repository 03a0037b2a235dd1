// relievo error: how far a mesh, from a file of ours, is from the fully sampled displaced surface of a scene.
#include <cstdio>
#include <memory>

#include "tb/analysis/scene_surface.hpp"
#include "tb/commands/commands.hpp"
#include "tb/commands/reporting.hpp"
#include "tb/commands/scene_arguments.hpp"
#include "tb/host/files.hpp"
#include "tb/host/read_mesh.hpp"

namespace relievo::tb {

namespace {

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
    if (!a->report.empty()) check_writable(a->report);
    const scene sc = a->scene.make();
    const surface displaced = world_surface(read_any_mesh(a->mesh), sc);
    const height_map heights = measured_map(sc);
    measured_error error;
    error.mesh = measure_error(displaced, measured_base(sc), heights);
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
