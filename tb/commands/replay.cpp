// relievo replay: recorded vectors again through a model; relievo replay --record makes some for a unit.
#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <memory>

#include "tb/commands/commands.hpp"
#include "tb/commands/reporting.hpp"
#include "tb/commands/rtl_arguments.hpp"
#include "tb/commands/told_difference.hpp"
#include "tb/commands/vectors.hpp"
#include "tb/cosim/unit_circuits.hpp"
#include "tb/host/files.hpp"
#include "tb/host/input_error.hpp"

namespace relievo::tb {

namespace {

struct arguments {
  std::string file, model = "hls", record;
  rtl_arguments rtl;
  std::size_t count = 1000;
  std::uint64_t seed = 1;
  std::optional<int> only;
};

[[noreturn]] void refuse_only(arguments const& a, std::string const& what, std::size_t count) {
  throw input_error("--only: " + std::to_string(*a.only) + " is not within 0.." + std::to_string(count - 1) + ", the " + what + " of " +
                    a.file);
}

int end_of(arguments const& a, unit_vectors const& v, std::size_t records, std::size_t different) {
  std::printf("%s: %s records, %s differ (%s, seed %" PRIu64 ")\n", v.unit.c_str(), grouped(records).c_str(), grouped(different).c_str(),
              a.model.c_str(), v.seed);
  return different == 0 ? 0 : 1;
}

// Base triangles with what they became, in order where both sides have one.
int replay_engine(arguments const& a, unit_vectors const& v, CLI::App const& app) {
  scene sc = scene_of(v, a.file);
  run_result recorded = run_of(v);
  if (a.only) {
    if (*a.only < 0 || static_cast<std::size_t>(*a.only) >= sc.triangles.size()) refuse_only(a, "base triangles", sc.triangles.size());
    sc = only_base_triangle(std::move(sc), *a.only);
  }
  const auto held_against = [&](scene const& s) {
    run_result expected = recorded;
    if (s.options.base_triangle) {
      auto& list = expected.triangles;
      const double index = s.triangles.front().index;
      list.erase(std::remove_if(list.begin(), list.end(), [index](golden::triangle_out const& t) { return t.index != index; }), list.end());
      for (golden::triangle_out& t : list) t.last = &t == &list.back();
    }
    const run_result run = run_model(a.model, s);
    expected.counts = run.counts;  // nothing is recorded of them
    return compare_runs("recorded", expected, a.model, run, expected.in_order && run.in_order);
  };
  const comparison c = held_against(sc);
  if (!c.first_difference.empty()) std::printf("%s", told_difference(c, sc, app, "--only", held_against).text.c_str());
  return end_of(a, v, c.triangles, c.triangles_different);
}

using records = std::vector<unit_vectors::words>;

records run_unit(arguments const& a, unit_vectors const& v, records const& in) {
  pure_unit const& unit = *find_unit(v.unit);
  if (a.model == "rtl") {
    unit_circuit const* circuit = find_unit_circuit(v.unit);
    if (circuit == nullptr)
      throw input_error(
          "--model: rtl has the engine's circuit alone in this program; the units' are in relievo_units_rtl: "
          "scripts/build.sh release relievo_units_rtl && build/relievo_units_rtl replay " +
          a.file + " --model rtl");
    return (*circuit)(in, v.regs);
  }
  records out;
  for (auto const& words : in) out.push_back(a.model == "hls" ? unit.hls(words, v.regs) : unit.golden(words, v.regs));
  return out;
}

int replay_unit(arguments const& a, unit_vectors v, CLI::App const& app) {
  std::size_t from = 0;
  if (a.only) {
    if (*a.only < 0 || static_cast<std::size_t>(*a.only) >= v.in.size()) refuse_only(a, "records", v.in.size());
    from = static_cast<std::size_t>(*a.only);
    v.in = {v.in[from]};
    v.out = {v.out[from]};
  }
  const records got = run_unit(a, v, v.in);
  std::vector<field> const& fields = find_unit(v.unit)->out;
  std::size_t different = 0;
  for (std::size_t i = 0; i < v.out.size(); ++i) {
    if (v.out[i] == got[i]) continue;
    if (different++ != 0) continue;
    const int at = v.out[i].size() == got[i].size() ? std::max(0, tb::difference(v.out[i], got[i])) : 0;
    const auto j = static_cast<std::size_t>(at);
    std::printf("first difference: record %zu, unit %s, field %s: %s, %s\n", from + i, v.unit.c_str(), fields[j].name.c_str(),
                word_text("recorded", v.out[i][j], fields[j]).c_str(), word_text(a.model, got[i][j], fields[j]).c_str());
    // A circuit may only fail with others before it in the pipeline.
    const bool alone = run_unit(a, v, {v.in[i]}).front() != v.out[i];
    std::printf("replay: %s%s\n", command_text(app, !a.only && alone ? " --only " + std::to_string(i) : "").c_str(),
                alone ? "" : " (this record alone does not differ: it takes those before it)");
  }
  return end_of(a, v, v.out.size(), different);
}

int replay(arguments const& a, CLI::App const& app) {
  const unit_vectors v = parse_vectors(read_bytes(a.file), a.file);
  if (a.model != "hls" && a.model != "golden" && a.model != "rtl" && !(a.model == "top" && v.unit == "engine"))
    throw input_error("--model: '" + a.model + "' cannot replay; known are golden, hls, rtl, and top for the engine");
  a.rtl.apply({a.model});
  return v.unit == "engine" ? replay_engine(a, v, app) : replay_unit(a, v, app);
}

int record(arguments const& a) {
  pure_unit const* unit = find_unit(a.record);
  if (unit == nullptr) {
    std::string known;
    for (pure_unit const& u : pure_units()) known += (known.empty() ? "" : ", ") + u.name;
    throw input_error("--record: '" + a.record + "' is no unit; known are " + known);
  }
  if (a.count < 1 || a.count > 10000000) throw input_error("--count: " + std::to_string(a.count) + " is not in 1..10000000");
  write_bytes(a.file, to_text(record_unit(*unit, a.count, a.seed)));
  std::printf("%s: %s records from golden, seed %" PRIu64 "\n", a.record.c_str(), grouped(a.count).c_str(), a.seed);
  return 0;
}

}  // namespace

command add_replay(CLI::App& app) {
  const auto a = std::make_shared<arguments>();
  app.add_option("FILE", a->file, "FILE.vec, from tessellate --vectors or --record")->required();
  app.add_option("--model", a->model, "golden|hls|rtl|top")->capture_default_str();
  app.add_option("--only", a->only, "N: this record of a unit, or this base triangle of the engine, alone; both count from 0");
  app.add_option("--record", a->record, "write FILE instead: random records of this unit, with golden's outputs");
  app.add_option("--count", a->count, "records to write")->capture_default_str();
  app.add_option("--seed", a->seed, "seed of the records to write; rtl, top: of stalls, latencies and what registers hold before reset")
      ->capture_default_str();
  a->rtl.add_to(app, false);
  app.footer(
      "Example: relievo replay displace.vec --record displace --count 1000 --seed 7 && relievo replay displace.vec --model hls\n"
      "The circuit of the engine is in every relievo; those of the units are in relievo_units_rtl.\nExit code 1 when a word differs.");
  CLI::App const* self = &app;
  return [a, self] {
    a->rtl.set_seed(a->seed);
    return a->record.empty() ? replay(*a, *self) : record(*a);
  };
}

}  // namespace relievo::tb
