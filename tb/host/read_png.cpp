// read_png: a displacement map from a PNG: grey, or colour whose channels agree everywhere, without transparency.
#include <algorithm>

#include "tb/host/input_error.hpp"
#include "tb/host/map.hpp"
#include "tb/host/png_codec.hpp"

namespace relievo::tb {

namespace {

void turn_upside_down(displacement_map& map) {
  const auto width = static_cast<std::ptrdiff_t>(map.width);
  for (std::ptrdiff_t low = 0, high = map.height - 1; low < high; ++low, --high)
    std::swap_ranges(map.texels.begin() + low * width, map.texels.begin() + (low + 1) * width, map.texels.begin() + high * width);
}

}  // namespace

displacement_map read_png(std::string_view bytes, std::string const& name) {
  decoded_png picture = decode_png(bytes, name, max_map_size);
  const bool grey = picture.channels < 3, alpha = picture.channels % 2 == 0;
  const unsigned opaque = picture.bits == 16 ? 65535u : 255u;
  const unsigned widen = picture.bits == 16 ? 1u : 257u;
  displacement_map map;
  map.name = name;
  map.width = picture.width;
  map.height = picture.height;
  const auto channels = static_cast<std::size_t>(picture.channels), width = static_cast<std::size_t>(picture.width);
  if (picture.channels == 1 && picture.bits == 16) {
    map.texels = std::move(picture.samples);
    turn_upside_down(map);
    return map;
  }
  map.texels.reserve(width * static_cast<std::size_t>(picture.height));
  for (int y = 0; y < picture.height; ++y) {
    std::uint16_t const* row = picture.samples.data() + static_cast<std::size_t>(picture.height - 1 - y) * width * channels;
    for (std::size_t x = 0; x < width; ++x) {
      std::uint16_t const* pixel = row + x * channels;
      if (!grey && (pixel[0] != pixel[1] || pixel[1] != pixel[2]))
        throw input_error(name + ": a colour picture; a displacement map needs one grey channel");
      if (alpha && pixel[channels - 1] != opaque)
        throw input_error(name + ": has transparent pixels; a displacement map needs all of them opaque");
      map.texels.push_back(static_cast<std::uint16_t>(pixel[0] * widen));
    }
  }
  return map;
}

}  // namespace relievo::tb
