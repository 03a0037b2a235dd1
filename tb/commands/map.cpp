// relievo map: what is done to maps before a scene: info, sat, normals, generate; levels is in map_levels.cpp.
#include "tb/host/map.hpp"

#include <cmath>
#include <cstdio>
#include <memory>

#include "tb/commands/commands.hpp"
#include "tb/commands/reporting.hpp"
#include "tb/commands/scene_arguments.hpp"
#include "tb/host/files.hpp"
#include "tb/host/filter_levels.hpp"
#include "tb/host/input_error.hpp"
#include "tb/model/hls_maps.hpp"

namespace relievo::tb {

namespace {

struct arguments {
  scene_arguments scene;
  std::string file, output, generator;
};

// The scene that the map alone makes: a plane, whatever else was given.
scene map_scene(arguments const& a) {
  scene_options o = a.scene.options();
  o.displacement = a.file;
  return make_scene(o);
}

// The filter levels that a file holds beside the map.
std::optional<filter_levels> levels_in(std::string const& file) {
  if (extension_of(file) != "exr") return std::nullopt;
  const std::string bytes = read_bytes(file);
  if (!has_levels(bytes)) return std::nullopt;
  return read_levels(bytes, file);
}

int print_info(arguments const& a) {
  scene_options const& o = a.scene.options();
  const std::optional<filter_levels> levels = levels_in(a.file);
  displacement_map map = load_map(a.file, o.sample_range);
  if (o.wrap) {
    map.wrap_u = (*o.wrap)[0];
    map.wrap_v = (*o.wrap)[1];
  }
  const map_extremes e = measure(map);
  double sum = 0.0;
  for (std::uint16_t s : map.texels) sum += s;
  const double mean = sum / static_cast<double>(map.texels.size());
  print_row("size", std::to_string(map.width) + " x " + std::to_string(map.height) + " samples");
  print_row("samples", std::to_string(e.min) + " .. " + std::to_string(e.max) + ", mean " + std::to_string(mean));
  if (map.range) {
    const double unit = (map.range->high - map.range->low) / 65535.0;
    char line[100];
    std::snprintf(line, sizeof line, "%.3f .. %.3f, mean %.3f", map.range->low + unit * e.min, map.range->low + unit * e.max,
                  map.range->low + unit * mean);
    print_row("units of the range", line);
  }
  print_row("steepest", std::to_string(e.max_delta_u) + " along u, " + std::to_string(e.max_delta_v) + " along v, samples over two texels");
  print_row("memory", grouped(map.texels.size() * 2) + " bytes, table " + grouped(map.texels.size() * 5) + ", normals " +
                          grouped(map.texels.size() * 6));
  if (levels) {
    const auto name = [](bool wrap) { return wrap ? "wrap" : "clamp"; };
    std::size_t texels = 0;
    for (displacement_map const& level : levels->levels) texels += level.texels.size();
    print_row("filter levels", std::to_string(levels->levels.size()) + ", " + name_of(levels->kind) + ", " +
                                   name(levels->levels[0].wrap_u) + "," + name(levels->levels[0].wrap_v) + ", " + grouped(texels * 2) +
                                   " bytes");
  }
  return 0;
}

// The table as little-endian words of 40 bits, row by row from v = 0.
int write_table(arguments const& a) {
  const scene sc = map_scene(a);
  std::string bytes;
  for (std::uint64_t word : build_summed_area_table(sc))
    for (int i = 0; i < 5; ++i) bytes += static_cast<char>((word >> (8 * i)) & 0xff);
  write_bytes(a.output, bytes);
  print_row("summed-area table", std::to_string(sc.map.width) + " x " + std::to_string(sc.map.height) + " words of 40 bits");
  return 0;
}

// The normals as a .ppm of 16 bits a component: 32768 + 2 * word, row 0 of the picture is v = 1.
int write_normals(arguments const& a) {
  const scene sc = map_scene(a);
  const built_normals normals = build_normal_map(sc);
  std::string bytes = "P6\n" + std::to_string(sc.map.width) + " " + std::to_string(sc.map.height) + "\n65535\n";
  for (int y = sc.map.height - 1; y >= 0; --y)
    for (int x = 0; x < sc.map.width; ++x)
      for (int i = 0; i < 3; ++i) {
        const std::uint64_t word =
            normals.words[static_cast<std::size_t>(y) * static_cast<std::size_t>(sc.map.width) + static_cast<std::size_t>(x)];
        const int value = 32768 + static_cast<std::int16_t>((word >> (16 * i)) & 0xffff);
        bytes += static_cast<char>(value >> 8);
        bytes += static_cast<char>(value & 0xff);
      }
  write_bytes(a.output, bytes);
  print_row("normal map", std::to_string(sc.map.width) + " x " + std::to_string(sc.map.height) + ", " + grouped(normals.saturations) +
                              " saturations, texel " + std::to_string(sc.texel_size.x) + " x " + std::to_string(sc.texel_size.y) +
                              " world units");
  return 0;
}

int write_generated(arguments const& a) {
  const std::optional<displacement_map> map = generate_map(a.generator);
  if (!map)
    throw input_error("map generate: '" + a.generator +
                      "' is no generator; known are half-donut, sine, checker, text, constant, maximum, ramp");
  write_map(*map, a.output);
  print_row(a.generator, std::to_string(map->width) + " x " + std::to_string(map->height) + " samples");
  return 0;
}

}  // namespace

command add_map(CLI::App& app) {
  const auto a = std::make_shared<arguments>();
  const auto chosen = std::make_shared<command>();
  app.require_subcommand(1);
  app.footer("Example: relievo map generate half-donut:512,512 -o donut.png && relievo map info donut.png");
  const auto add = [&](char const* name, char const* what, int (*run)(arguments const&), bool writes, char const* example) {
    CLI::App* sub = app.add_subcommand(name, what);
    if (run == write_generated)
      sub->add_option("NAME", a->generator, "half-donut, sine, checker, text, constant, maximum, ramp, each [:W,H]")->required();
    else
      sub->add_option("FILE", a->file, "the displacement map, or a generator's name")->required();
    if (writes) sub->add_option("-o,--output", a->output, "the file to write")->required();
    if (run != write_generated) a->scene.add_to(*sub);
    sub->footer(example);
    sub->callback([a, chosen, run] {
      *chosen = [a, run] {
        if (!a->output.empty()) check_writable(a->output);
        return run(*a);
      };
    });
  };
  add("info", "size, range and slopes of a map", print_info, false, "Example: relievo map info terrain.png --sample-range 236,1076");
  add("sat", "the summed-area table, as words of 5 bytes", write_table, true, "Example: relievo map sat terrain.png -o terrain.sat");
  add("normals", "the normal map for a scale, as a 16-bit .ppm (word + 32768)", write_normals, true,
      "Example: relievo map normals terrain.png --scale 0.2 -o terrain_normals.ppm");
  add("generate", "a generated map as a 16-bit .png", write_generated, true,
      "Example: relievo map generate half-donut:512,512 -o donut.png");
  CLI::App* levels = app.add_subcommand("levels", "the map and its filter levels as one .exr");
  levels->callback([chosen, run = add_map_levels(*levels)] { *chosen = run; });
  return [chosen] { return (*chosen)(); };
}

}  // namespace relievo::tb
