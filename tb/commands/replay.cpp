// relievo replay: recorded vectors again through a model; relievo replay --record makes some for a unit.
#include <cinttypes>
#include <cstdio>
#include <memory>

#include "hls/edge/triangle.hpp"
#include "tb/commands/commands.hpp"
#include "tb/commands/reporting.hpp"
#include "tb/commands/vectors.hpp"
#include "tb/host/files.hpp"
#include "tb/host/input_error.hpp"

namespace relievo::tb {

namespace {

struct arguments {
  std::string file, model = "hls", record;
  std::size_t count = 1000;
  std::uint64_t seed = 1;
};

// Prints the first record that differs; returns how many do.
std::size_t report(std::vector<std::vector<std::int64_t>> const& expected, std::vector<std::vector<std::int64_t>> const& got,
                   std::vector<field> const& fields) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < expected.size() || i < got.size(); ++i) {
    if (i < expected.size() && i < got.size() && expected[i] == got[i]) continue;
    if (different++ != 0) continue;
    if (i >= expected.size() || i >= got.size()) {
      std::printf("record %zu: %zu recorded, %zu put out\n", i, expected.size(), got.size());
      continue;
    }
    const int j = got[i].size() == expected[i].size() ? difference(expected[i], got[i]) : 0;
    field const& f = fields[static_cast<std::size_t>(j)];
    const std::int64_t a = expected[i][static_cast<std::size_t>(j)], b = got[i][static_cast<std::size_t>(j)];
    std::printf("record %zu, field %s: recorded %" PRIx64 " (%.12g), got %" PRIx64 " (%.12g)\n", i, f.name.c_str(),
                static_cast<std::uint64_t>(a), f.value(a), static_cast<std::uint64_t>(b), f.value(b));
  }
  return different;
}

int replay(arguments const& a) {
  const unit_vectors v = parse_vectors(read_bytes(a.file), a.file);
  if (a.model != "hls" && a.model != "golden") throw input_error("--model: '" + a.model + "' cannot replay; known are golden, hls");
  std::vector<std::vector<std::int64_t>> got;
  std::vector<field> fields;
  if (v.unit == "engine") {
    const scene sc = scene_of(v, a.file);
    bool exact = true;
    for (golden::triangle_out const& t : run_model(a.model, sc).triangles) got.push_back(golden_words<hls::triangle_out>(t, exact));
    fields = layout<hls::triangle_out>();
  } else {
    pure_unit const& unit = *find_unit(v.unit);
    for (auto const& in : v.in) got.push_back(a.model == "hls" ? unit.hls(in, v.regs) : unit.golden(in, v.regs));
    fields = unit.out;
  }
  const std::size_t different = report(v.out, got, fields);
  std::printf("%s: %s records, %s differ (%s, seed %" PRIu64 ")\n", v.unit.c_str(), grouped(v.out.size()).c_str(),
              grouped(different).c_str(), a.model.c_str(), v.seed);
  return different == 0 ? 0 : 1;
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
  app.add_option("--model", a->model, "golden|hls")->capture_default_str();
  app.add_option("--record", a->record, "write FILE instead: random records of this unit, with golden's outputs");
  app.add_option("--count", a->count, "records to write")->capture_default_str();
  app.add_option("--seed", a->seed, "seed of the records")->capture_default_str();
  app.footer("Example: relievo replay displace.vec --record displace --count 1000 --seed 7 && relievo replay displace.vec --model hls");
  return [a] { return a->record.empty() ? replay(*a) : record(*a); };
}

}  // namespace relievo::tb
