// map_generators: displacement maps of our own making (generate_map of map.hpp). Each is a formula of the texel's place, so any size works.
//
//   half-donut   the upper half of a torus lying on the plane: radius 0.3 to the ring's middle, 0.14 of the ring, of the map's extent
//   sine         1/2 + 1/4 (sin 2 pi 4 x/W + sin 2 pi 4 y/H): four periods an axis, wraps without a seam
//   checker      8 x 8 squares of 0 and 65535
//   text         RELIEVO, raised, over four fifths of the width
//   constant     32768;   maximum   65535;   ramp   from 0 to 65535 along u
#include <algorithm>
#include <array>
#include <cmath>

#include "tb/host/input_error.hpp"
#include "tb/host/map.hpp"
#include "tb/host/names.hpp"

namespace relievo::tb {

namespace {

constexpr double pi = 3.14159265358979323846;

double half_donut(double x, double y) {
  const double from_ring = std::hypot(x - 0.5, y - 0.5) - 0.3;
  const double part = from_ring / 0.14;
  return std::sqrt(std::fmax(0.0, 1.0 - part * part));
}

// Seven rows from the top, five columns each, '#' raised.
using glyph = std::array<char const*, 7>;
constexpr int glyph_width = 5, glyph_height = 7;
constexpr std::array<glyph, 7> relievo = {{
    {"#### ", "#   #", "#   #", "#### ", "# #  ", "#  # ", "#   #"},
    {"#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#####"},
    {"#    ", "#    ", "#    ", "#    ", "#    ", "#    ", "#####"},
    {" ### ", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "},
    {"#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#####"},
    {"#   #", "#   #", "#   #", "#   #", "#   #", " # # ", "  #  "},
    {" ### ", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "},
}};

// Whether the point is on a stroke; x and y are in dots from the text's lower left corner.
bool raised(double x, double y) {
  const double letter = std::floor(x / (glyph_width + 1));
  if (letter < 0.0 || letter >= static_cast<double>(relievo.size()) || y < 0.0 || y >= glyph_height) return false;
  const double column = x - letter * (glyph_width + 1);
  if (column >= glyph_width) return false;
  const auto row = static_cast<std::size_t>(glyph_height - 1 - static_cast<int>(y));
  return relievo[static_cast<std::size_t>(letter)][row][static_cast<std::size_t>(column)] == '#';
}

// Averaged over 4 x 4 points a texel, so that strokes have slopes of one texel instead of steps.
double text(int x, int y, int width, int height) {
  const double dots = static_cast<double>(relievo.size()) * (glyph_width + 1) - 1.0;
  const double dot = std::fmin(0.8 * width / dots, 0.8 * height / glyph_height);
  int hits = 0;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      const double px = x + (i + 0.5) / 4.0 - 0.5 * width, py = y + (j + 0.5) / 4.0 - 0.5 * height;
      if (raised(px / dot + 0.5 * dots, py / dot + 0.5 * glyph_height)) ++hits;
    }
  }
  return hits / 16.0;
}

template <class Height>
void fill(displacement_map& map, Height const& height) {
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const double value = std::clamp(height(x, y), 0.0, 1.0);
      map.texels.push_back(static_cast<std::uint16_t>(std::floor(value * 65535.0 + 0.5)));
    }
}

}  // namespace

std::optional<displacement_map> generate_map(std::string const& spec) {
  displacement_map map;
  map.name = spec;
  for (char const* name : {"half-donut", "sine", "checker", "text", "constant", "maximum", "ramp"}) {
    const std::optional<std::vector<int>> size = numbers_of(spec, name, 2);
    if (!size) continue;
    map.width = size->empty() ? 256 : (*size)[0];
    map.height = size->size() < 2 ? map.width : (*size)[1];
    if (map.width > max_map_size || map.height > max_map_size)
      throw input_error(spec + ": at most " + std::to_string(max_map_size) + " samples along an axis are possible");
    const int w = map.width, h = map.height;
    map.texels.reserve(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
    // Samples on a grid from border to border, the middle of an axis of one.
    const auto across = [](int i, int n) { return n == 1 ? 0.5 : static_cast<double>(i) / (n - 1); };
    const std::string kind = name;
    if (kind == "half-donut") {
      fill(map, [&](int x, int y) { return half_donut(across(x, w), across(y, h)); });
    } else if (kind == "sine") {
      fill(map, [&](int x, int y) { return 0.5 + 0.25 * (std::sin(8.0 * pi * x / w) + std::sin(8.0 * pi * y / h)); });
    } else if (kind == "checker") {
      fill(map, [&](int x, int y) { return (x * 8 / w + y * 8 / h) % 2 == 0 ? 0.0 : 1.0; });
    } else if (kind == "text") {
      fill(map, [&](int x, int y) { return text(x, y, w, h); });
    } else if (kind == "constant") {
      fill(map, [](int, int) { return 32768.0 / 65535.0; });
    } else if (kind == "maximum") {
      fill(map, [](int, int) { return 1.0; });
    } else {
      fill(map, [&](int x, int) { return across(x, w); });
    }
    return map;
  }
  return std::nullopt;
}

}  // namespace relievo::tb
