// map: displacement maps, from files and generators.
//
//   texels[y * width + x], row y = 0 is v = 0, the bottom row of the picture. 16 bits a sample, 1..8192 samples along an axis.
//   8-bit pictures are widened by * 257, other ranges of a .pgm in proportion, so that the brightest value is 65535.
//   .png  8 or 16 bit, grey (or colour with R = G = B), opaque
//   .pgm  binary (P5) or text (P2)
//   .exr  the channel Y or the only one, half or float: 0..1 becomes 0..65535; with a sample range LO..HI becomes 0..65535
//   names half-donut, sine, checker, text, constant, maximum, ramp, each also name:W,H (default 256 x 256)
//   Errors: input_error, one line with the file's name and the field.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace relievo::tb {

// The physical values that the samples 0 and 65535 stand for.
struct sample_range {
  double low = 0.0, high = 65535.0;
};

struct displacement_map {
  int width = 0, height = 0;
  std::vector<std::uint16_t> texels;
  bool wrap_u = false, wrap_v = false;
  std::string name;
  std::optional<sample_range> range;

  std::uint16_t at(int x, int y) const {
    return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

// What the samples of a map span, and its steepest central differences (borders as the normal_map builder takes them).
struct map_extremes {
  int min = 0, max = 0;
  int max_delta_u = 0, max_delta_v = 0;
};
map_extremes measure(displacement_map const& map);

// A generator's name or a file. wrap_u and wrap_v are left false.
displacement_map load_map(std::string const& spec, std::optional<sample_range> range);
displacement_map read_map(std::string const& path, std::optional<sample_range> range);
// Nothing when `spec` names no generator.
std::optional<displacement_map> generate_map(std::string const& spec);

// The readers from memory; `name` stands in the messages.
displacement_map read_png(std::string_view bytes, std::string const& name);
displacement_map read_pgm(std::string_view bytes, std::string const& name);
displacement_map read_exr(std::string_view bytes, std::string const& name, std::optional<sample_range> range);

// A 16-bit grey PNG of the map, the same bytes for the same map.
void write_map(displacement_map const& map, std::string const& path);

constexpr int max_map_size = 8192;

}  // namespace relievo::tb
