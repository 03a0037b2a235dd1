// relievo map levels: a map and all its filter levels as one file (filter_levels.hpp); a line for each level.
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tb/analysis/progress.hpp"
#include "tb/commands/commands.hpp"
#include "tb/commands/reporting.hpp"
#include "tb/host/files.hpp"
#include "tb/host/filter_levels.hpp"
#include "tb/host/input_error.hpp"
#include "tb/host/scene_options.hpp"

namespace relievo::tb {

namespace {

struct arguments {
  std::string file, output, kind;
  std::optional<std::string> address, sample_range;
  std::optional<int> iterations;
};

level_kind kind_of(arguments const& a) {
  const std::optional<level_kind> kind = level_kind_of(a.kind);
  if (!kind) throw input_error("--kind: '" + a.kind + "' is no kind of level; averaged, maximum, minimum or variational is needed");
  if (a.iterations && *kind != level_kind::variational) throw input_error("--iterations: only levels of --kind variational are iterated");
  if (a.iterations && *a.iterations < 1) throw input_error("--iterations: " + std::to_string(*a.iterations) + "; at least 1 is needed");
  return *kind;
}

displacement_map map_of(arguments const& a) {
  std::optional<sample_range> range;
  if (a.sample_range) range = parse_sample_range(*a.sample_range, "--sample-range");
  const std::array<bool, 2> wrap = a.address ? parse_address(*a.address, "--address") : std::array<bool, 2>{false, false};
  displacement_map map = load_map(a.file, range);
  map.wrap_u = wrap[0];
  map.wrap_v = wrap[1];
  return map;
}

// Volumes in samples (units of the range, when given) times texels; their quotient by the texels of the map is the mean distance.
void print_level(displacement_map const& map, displacement_map const& level, int number, level_kind kind, level_report const& report) {
  const double unit = map.range ? (map.range->high - map.range->low) / 65535.0 : 1.0;
  const double texels = static_cast<double>(map.width) * map.height;
  const auto volume = [&](double v) { return grouped(static_cast<std::uint64_t>(std::abs(unit) * v + 0.5)); };
  std::string line = std::to_string(level.width) + " x " + std::to_string(level.height) + " texels, volume ";
  char end[100];
  std::snprintf(end, sizeof end, ", mean distance %.2f", std::abs(unit) * report.volume / texels);
  line += volume(report.volume) + end;
  if (kind != level_kind::averaged) {
    const double ratio = report.averaged_volume > 0.0 ? 100.0 * report.volume / report.averaged_volume : 100.0;
    std::snprintf(end, sizeof end, ", %.1f %% of the averaged level's ", ratio);
    line += end + volume(report.averaged_volume);
  }
  if (kind == level_kind::variational) line += ", " + grouped(static_cast<std::uint64_t>(report.passes)) + " iterations";
  print_row("level " + std::to_string(number), line);
}

int write(arguments const& a) {
  const level_kind kind = kind_of(a);
  if (extension_of(a.output) != "exr") throw input_error(a.output + ": filter levels are written as .exr");
  check_writable(a.output);
  const displacement_map map = map_of(a);
  std::vector<level_report> reports;
  progress bar("passes over the map", 0);
  const filter_levels made = make_levels(map, kind, a.iterations.value_or(default_level_passes), &reports, [&] { bar.advance(); });
  write_levels(made, a.output);
  print_row(name_of(kind), std::to_string(made.levels.size()) + " levels, " + std::to_string(map.width) + " x " +
                               std::to_string(map.height) + " samples to 1 x 1");
  for (std::size_t l = 1; l < made.levels.size(); ++l) print_level(map, made.levels[l], static_cast<int>(l), kind, reports[l]);
  return 0;
}

}  // namespace

command add_map_levels(CLI::App& app) {
  const auto a = std::make_shared<arguments>();
  app.add_option("FILE", a->file, "the displacement map, or a generator's name")->required();
  app.add_option("-o,--output", a->output, "the file to write, .exr")->required();
  app.add_option("--kind", a->kind, "averaged|maximum|minimum|variational")->required();
  app.add_option("--address", a->address, "clamp|wrap[,clamp|wrap] beyond the map's borders in u, v; default clamp");
  app.add_option("--sample-range", a->sample_range, "LO,HI: what the samples 0 and 65535 mean (metres); the volumes use it");
  app.add_option("--iterations", a->iterations, "variational: at most so many a level; default " + std::to_string(default_level_passes));
  app.footer("Example: relievo map levels terrain.png --kind variational -o terrain_levels.exr");
  return [a] { return write(*a); };
}

}  // namespace relievo::tb
