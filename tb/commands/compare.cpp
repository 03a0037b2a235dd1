// relievo compare: one scene through several models, their outputs equal word for word or the first difference.
#include "tb/model/compare.hpp"

#include <cstdio>
#include <memory>
#include <sstream>

#include "golden/edge/redecision_summary.hpp"
#include "golden/surface/summed_area_table.hpp"
#include "tb/commands/commands.hpp"
#include "tb/commands/reporting.hpp"
#include "tb/commands/rtl_arguments.hpp"
#include "tb/commands/scene_arguments.hpp"
#include "tb/commands/told_difference.hpp"
#include "tb/host/input_error.hpp"

namespace relievo::tb {

namespace {

std::vector<std::string> split_names(std::string const& text) {
  std::vector<std::string> names;
  std::istringstream in(text);
  for (std::string name; std::getline(in, name, ',');) names.push_back(name);
  if (names.size() < 2) throw input_error("--models: '" + text + "' names fewer than two models; right would be golden,hls");
  for (std::string const& name : names)
    if (check_model_name(name); name == "ideal")
      throw input_error("--models: ideal is not rounded and equals no other model word for word; take golden,hls");
  return names;
}

// What the ideal decides on the records of a golden run, edge by edge.
golden::redecision_summary decide_again(scene const& sc) {
  std::vector<std::uint64_t> table;
  if (sc.regs.pass.use_sht) table = golden::summed_area_table(sc.map.texels.data(), sc.map.width, sc.map.height);
  const golden::redecide redecide(sc.regs, {sc.map.texels.data(), table.empty() ? nullptr : table.data(), sc.normal_map});
  golden::redecision_summary summary;
  run_hooks hooks;
  hooks.traced = [&](golden::edge_trace const& e) { summary.add(e, redecide(e)); };
  make_model("golden", sc)->run(hooks);
  return summary;
}

nlohmann::json to_json(golden::redecision_summary const& s) {
  nlohmann::json json = {
      {"edges", s.edges}, {"splits_differing", s.splits}, {"places_differing", s.places}, {"middles_moved", s.middles_moved}};
  s.each_test([&](char const* name, golden::test_summary const& t) {
    if (t.compared != 0)
      json["tests"][name] = {{"compared", t.compared},           {"differing", t.differing},
                             {"unexplained", t.unexplained},     {"largest_change", t.largest_change},
                             {"largest_bound", t.largest_bound}, {"largest_share_of_threshold", t.largest_share}};
  });
  s.each_register([&](char const* name, golden::register_summary const& r) {
    json["registers"][name] = {{"words", r.words}, {"max_lsb", r.largest}, {"rms_lsb", r.rms()}};
  });
  return json;
}

void print_decisions(golden::redecision_summary const& s) {
  print_row("ideal on golden", grouped(s.splits) + " of " + grouped(s.edges) + " edges decided otherwise");
  s.each_test([](char const* name, golden::test_summary const& t) {
    if (t.compared == 0) return;
    char line[160];
    std::snprintf(line, sizeof line, "%s differ, at most %.4f %% of the threshold; %s beyond the derived margin",
                  grouped(t.differing).c_str(), 100.0 * t.largest_share, grouped(t.unexplained).c_str());
    print_row(std::string("  ") + name, line);
  });
  s.each_register([](char const* name, golden::register_summary const& r) {
    if (r.words == 0) return;
    char line[100];
    std::snprintf(line, sizeof line, "at most %.3f LSB, RMS %.3f", r.largest, r.rms());
    print_row(std::string("  ") + name, line);
  });
}

std::string rate_text(double per_second) {
  char text[60];
  std::snprintf(text, sizeof text, "%.2f million edge tests/s", per_second / 1e6);
  return text;
}

}  // namespace

command add_compare(CLI::App& app) {
  struct arguments {
    scene_arguments scene;
    rtl_arguments rtl;
    output_arguments out;
    std::string models = "golden,hls";
    bool rate = false, decisions = false;
  };
  const auto a = std::make_shared<arguments>();
  app.add_option("--models", a->models, "two or more of golden,hls,rtl,top")->capture_default_str();
  a->scene.add_to(app);
  a->scene.add_base_triangle(app);
  a->rtl.add_to(app);
  a->out.add_to(app);
  app.add_flag("--rate", a->rate, "measure the models' rates too")->group("Output");
  app.add_flag("--decisions", a->decisions, "let the ideal model decide every edge of the golden run again, and print the differences")
      ->group("Output");
  app.footer("Example: relievo compare --mesh sphere:8 --displacement sine --models golden,hls\nExit code 1 when a word differs.");
  CLI::App const* self = &app;
  return [a, self] {
    const std::vector<std::string> names = split_names(a->models);
    a->out.check(names.back());
    a->rtl.apply(names);
    a->scene.check_measure(a->out.measure);
    if ((a->rate || a->decisions) && a->scene.options().engine != engine_kind::edge)
      throw input_error(std::string(a->rate ? "--rate" : "--decisions") + ": is of the edge engine; leave it out with --engine sweep");
    const scene sc = a->scene.make();
    std::vector<run_result> runs;
    for (std::string const& name : names) {
      run_hooks hooks;
      hooks.progress = progress_hook(name, sc);
      runs.push_back(run_model(name, sc, hooks));
    }
    std::optional<measured_error> error;
    if (a->out.measure) error = measure(runs.back().triangles, sc);

    nlohmann::json report = counts_json(runs.back());
    report["models"] = names;
    report["scene"] = to_json(sc);
    if (error) report["error"] = to_json(*error);
    print_run(runs.back(), sc, error);
    for (std::string const& name : names) {
      const golden::counters& c = runs.back().counts;
      print_circuit(name, c.edge_tests, c.triangles_out);
      report_circuit(report, name, c.edge_tests);
    }
    if (a->rate) {
      for (std::string const& name : names) {
        if (name == "rtl" || name == "top") continue;  // told in clocks above
        const double rate = edge_tests_per_second(*make_model(name, sc));
        report["edge_tests_per_second"][name] = rate;
        print_row("rate, " + name, rate_text(rate));
      }
    }
    if (a->decisions) {
      const golden::redecision_summary summary = decide_again(sc);
      print_decisions(summary);
      report["decisions"] = to_json(summary);
    }
    bool equal = true;
    std::string text;
    told first;
    for (std::size_t i = 1; i < names.size(); ++i) {
      const auto held_against = [&](run_result const& x, run_result const& y) {
        return compare_runs(names.front(), x, names[i], y, x.in_order && y.in_order);
      };
      const comparison c = held_against(runs.front(), runs[i]);
      equal = equal && c.equal();
      text += names[i] + (c.equal() ? " = " : " != ") + names.front() + ": " + grouped(c.triangles) + " triangles, " +
              grouped(c.words_different) + " words differ\n";
      for (std::string const& line : c.counters_different) text += "  counter " + line + "\n";
      if (first.text.empty() && !c.first_difference.empty())
        first = told_difference(c, sc, *self, "--base-triangle",
                                [&](scene const& one) { return held_against(run_model(names.front(), one), run_model(names[i], one)); });
      report["words_different"][names[i]] = c.words_different;
    }
    report["equal"] = equal;
    if (!first.text.empty()) report["first_difference"] = first.json;
    write_outputs(a->out, runs.back(), sc);
    write_report(a->out, report);
    std::printf("%s%s", text.c_str(), first.text.c_str());
    return equal ? 0 : 1;
  };
}

}  // namespace relievo::tb
