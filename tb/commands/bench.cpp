// relievo bench: rates of every model on a scene, on this machine.
#include <cstdio>
#include <memory>

#include "tb/commands/commands.hpp"
#include "tb/commands/reporting.hpp"
#include "tb/commands/scene_arguments.hpp"
#include "tb/host/files.hpp"
#include "tb/host/input_error.hpp"

namespace relievo::tb {

command add_bench(CLI::App& app) {
  struct arguments {
    scene_arguments scene;
    std::string report;
  };
  const auto a = std::make_shared<arguments>();
  a->scene.add_to(app);
  app.add_option("--report", a->report, "OUT.json")->group("Output");
  app.footer("Example: relievo bench --mesh plane:8 --displacement half-donut --tests nt,sht,pt,vt,ct");
  return [a] {
    if (!a->report.empty()) check_writable(a->report);
    if (a->scene.options().engine != engine_kind::edge) throw input_error("--engine: bench measures the edge engine; take --engine edge");
    const scene sc = a->scene.make();
    nlohmann::json report = {{"scene", to_json(sc)}};
    for (std::string const& name : model_names()) {
      const std::unique_ptr<model> m = make_model(name, sc);
      const golden::counters counts = m->run({});
      const double rate = edge_tests_per_second(*m);
      char line[100];
      std::snprintf(line, sizeof line, "%10.0f edge tests/s, %s edge tests, %s triangles", rate, grouped(counts.edge_tests).c_str(),
                    grouped(counts.triangles_out).c_str());
      print_row(name, line);
      report["models"][name] = {
          {"edge_tests_per_second", rate}, {"edge_tests", counts.edge_tests}, {"triangles_out", counts.triangles_out}};
    }
    output_arguments out;
    out.report = a->report;
    write_report(out, report);
    return 0;
  };
}

}  // namespace relievo::tb
