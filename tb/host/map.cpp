#include "tb/host/map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tb/host/files.hpp"
#include "tb/host/input_error.hpp"
#include "tb/host/png_codec.hpp"

namespace relievo::tb {

namespace {

// The largest |D(i+1) - D(i-1)| along one axis of `size` texels, `at(i)` giving the texel; borders as in surface/normal_map.
template <class Line>
int steepest(int size, bool wrap, Line const& at) {
  if (size == 1) return 0;
  int largest = 0;
  for (int i = 1; i + 1 < size; ++i) largest = std::max(largest, std::abs(at(i + 1) - at(i - 1)));
  if (wrap) return std::max({largest, std::abs(at(1) - at(size - 1)), std::abs(at(0) - at(size - 2))});
  return std::max({largest, 2 * std::abs(at(1) - at(0)), 2 * std::abs(at(size - 1) - at(size - 2))});
}

}  // namespace

map_extremes measure(displacement_map const& map) {
  map_extremes e;
  const auto [min, max] = std::minmax_element(map.texels.begin(), map.texels.end());
  e.min = *min;
  e.max = *max;
  for (int y = 0; y < map.height; ++y)
    e.max_delta_u = std::max(e.max_delta_u, steepest(map.width, map.wrap_u, [&](int x) { return int(map.at(x, y)); }));
  // Row against row, so that a large map is walked in the order of its memory.
  const auto rows = [&](int a, int b, int weight) {
    for (int x = 0; x < map.width; ++x) e.max_delta_v = std::max(e.max_delta_v, weight * std::abs(int(map.at(x, a)) - int(map.at(x, b))));
  };
  const int h = map.height;
  for (int y = 1; y + 1 < h; ++y) rows(y + 1, y - 1, 1);
  if (h > 1 && map.wrap_v) {
    rows(1, h - 1, 1);
    rows(0, h - 2, 1);
  } else if (h > 1) {
    rows(1, 0, 2);
    rows(h - 1, h - 2, 2);
  }
  return e;
}

displacement_map read_map(std::string const& path, std::optional<sample_range> range) {
  if (range && !(std::isfinite(range->low) && std::isfinite(range->high) && range->low != range->high))
    throw input_error("--sample-range: two different finite numbers are needed");
  const std::string extension = extension_of(path);
  displacement_map map;
  if (extension == "png") {
    map = read_png(read_bytes(path), path);
  } else if (extension == "pgm") {
    map = read_pgm(read_bytes(path), path);
  } else if (extension == "exr") {
    map = read_exr(read_bytes(path), path, range);
  } else {
    throw input_error(path +
                      ": not a displacement map; a file .png, .pgm or .exr, or half-donut, sine, checker, text, constant, maximum, ramp "
                      "is needed");
  }
  map.range = range;
  return map;
}

displacement_map load_map(std::string const& spec, std::optional<sample_range> range) {
  std::optional<displacement_map> made = generate_map(spec);
  if (!made) return read_map(spec, range);
  made->range = range;
  return std::move(*made);
}

void write_map(displacement_map const& map, std::string const& path) {
  std::vector<std::uint16_t> from_top;
  from_top.reserve(map.texels.size());
  const auto width = static_cast<std::ptrdiff_t>(map.width);
  for (std::ptrdiff_t y = map.height - 1; y >= 0; --y)
    from_top.insert(from_top.end(), map.texels.begin() + y * width, map.texels.begin() + (y + 1) * width);
  write_bytes(path, encode_png16(map.width, map.height, 1, from_top));
}

}  // namespace relievo::tb
