// png_codec: pictures as PNG bytes, by libpng; the same picture gives the same bytes.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace relievo::tb {

// channels 1 (grey) or 3 (RGB), rows from the top, width * channels values each.
std::string encode_png8(int width, int height, int channels, std::vector<std::uint8_t> const& pixels);
std::string encode_png16(int width, int height, int channels, std::vector<std::uint16_t> const& pixels);

}  // namespace relievo::tb
