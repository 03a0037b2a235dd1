// relievo check: is a mesh whole? A file (with what it was made from, or its base mesh), or a model's output, exactly.
#include "tb/analysis/check.hpp"

#include <cstdio>
#include <memory>

#include "tb/analysis/check_sweep.hpp"
#include "tb/commands/commands.hpp"
#include "tb/commands/reporting.hpp"
#include "tb/commands/scene_arguments.hpp"
#include "tb/host/files.hpp"
#include "tb/host/input_error.hpp"

namespace relievo::tb {

namespace {

struct arguments {
  scene_arguments scene;
  std::string file, base, model, report;
  bool scene_given = false;
};

// The scene's own warnings are not printed: the report has those of the base mesh.
check_report run_check(arguments const& a) {
  if (a.file.empty() && a.model.empty()) throw input_error("check: name a mesh file, or a model with --model to check its output exactly");
  if (!a.model.empty()) {
    if (!a.file.empty()) throw input_error("check: a mesh file and --model exclude each other");
    const scene sc = make_scene(a.scene.options());
    // The weights are golden's; hls has the same words in the same order (relievo compare), so golden's stand for both.
    const run_result run = run_model(a.model, sc);
    if (run.sweep) return check_sweep(run, sc.regs.map);
    check_options options;
    options.culled = sc.options.cull;
    return check_output(run.triangles, sc.triangles, sc.regs.map, options);
  }
  const loose_mesh file = read_any_mesh(a.file);
  if (file.m.triangles.empty()) throw input_error(a.file + ": no triangles; there is nothing to check");
  if (!a.base.empty()) return check_file(file, read_mesh(a.base));
  if (!a.scene_given) return check_file(file);
  const scene sc = make_scene(a.scene.options());
  check_options options;
  options.culled = sc.options.cull;
  return check_file(file, sc, options);
}

}  // namespace

command add_check(CLI::App& app) {
  const auto a = std::make_shared<arguments>();
  app.add_option("MESH", a->file, "the tessellated mesh, .obj|.ply|.glb");
  app.add_option("--base", a->base, "its base mesh, .obj|.ply|.glb");
  app.add_option("--model", a->model, "ideal|golden|hls: run the scene and check its output, in exact weights where the model has them");
  a->scene.add_to(app);
  app.add_option("--report", a->report, "OUT.json")->group("Output");
  app.footer(
      "Examples: relievo check donut.ply --mesh plane:8 --displacement half-donut\n"
      "          relievo check --model golden --mesh sphere:8 --displacement sine\nExit code 1 on cracks.");
  CLI::App* self = &app;
  return [a, self] {
    if (!a->report.empty()) check_writable(a->report);
    a->scene_given = self->count("--mesh") + self->count("--displacement") > 0;
    const check_report report = run_check(*a);
    for (std::string const& line : report.warnings) std::fprintf(stderr, "relievo: warning: %s\n", line.c_str());
    std::printf("%s", to_text(report).c_str());
    output_arguments out;
    out.report = a->report;
    write_report(out, to_json(report));
    return report.clean() ? 0 : 1;
  };
}

}  // namespace relievo::tb
