// png_codec: pictures to and from PNG bytes, by libpng. The same picture gives the same bytes.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace relievo::tb {

// channels 1 (grey) or 3 (RGB), rows from the top, width * channels values each.
std::string encode_png8(int width, int height, int channels, std::vector<std::uint8_t> const& pixels);
std::string encode_png16(int width, int height, int channels, std::vector<std::uint16_t> const& pixels);

// Samples as they are stored (no gamma), palettes and bits below 8 expanded; rows from the top.
struct decoded_png {
  int width = 0, height = 0;
  int channels = 0;  // 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA
  int bits = 0;      // 8 or 16
  std::vector<std::uint16_t> samples;
};
// input_error, naming `name`, for what is no PNG, damaged, or beyond `largest` samples along an axis.
decoded_png decode_png(std::string_view bytes, std::string const& name, int largest);

}  // namespace relievo::tb
