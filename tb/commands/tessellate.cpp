// relievo tessellate: one scene through one model; mesh, picture and report.
#include <memory>

#include "tb/commands/commands.hpp"
#include "tb/commands/reporting.hpp"
#include "tb/commands/rtl_arguments.hpp"
#include "tb/commands/scene_arguments.hpp"
#include "tb/commands/vectors.hpp"
#include "tb/host/input_error.hpp"

namespace relievo::tb {

command add_tessellate(CLI::App& app) {
  struct arguments {
    scene_arguments scene;
    rtl_arguments rtl;
    output_arguments out;
    std::string model = "hls", vectors;
  };
  const auto a = std::make_shared<arguments>();
  app.add_option("--model", a->model, "ideal|golden|hls|rtl|top")->capture_default_str();
  a->scene.add_to(app);
  a->scene.add_base_triangle(app);
  a->rtl.add_to(app);
  a->out.add_to(app);
  app.add_option("--vectors", a->vectors, "OUT.vec: the scene and its output as raw words, for replay")->group("Output");
  app.footer("Example: relievo tessellate --mesh plane:8 --displacement half-donut -o donut.ply --image donut.png");
  return [a] {
    check_model_name(a->model);
    if (!a->vectors.empty() && a->model == "ideal")
      throw input_error("--vectors: the ideal model's output has no raw words; take golden or hls");
    a->out.check(a->model, {a->vectors});
    a->rtl.apply({a->model});
    a->scene.check_measure(a->out.measure);
    if (!a->vectors.empty() && a->scene.options().engine != engine_kind::edge)
      throw input_error("--vectors: records runs of the edge engine; leave it out with --engine sweep");
    const scene sc = a->scene.make();
    run_hooks hooks;
    hooks.progress = progress_hook(a->model, sc);
    const run_result run = run_model(a->model, sc, hooks);
    hooks = {};
    std::optional<measured_error> error;
    if (a->out.measure) error = measure(run.triangles, sc);

    nlohmann::json report = counts_json(run);
    report["model"] = a->model;
    report["scene"] = to_json(sc);
    report["seconds"] = run.seconds;
    if (error) report["error"] = to_json(*error);
    report_circuit(report, a->model, run.counts.edge_tests);
    if (!a->vectors.empty()) write_engine_vectors(a->vectors, sc, run);
    write_outputs(a->out, run, sc);
    write_report(a->out, report);
    print_run(run, sc, error);
    print_circuit(a->model, run.counts.edge_tests, run.counts.triangles_out);
    return 0;
  };
}

}  // namespace relievo::tb
