// png_file: a picture as a small PNG, always the same bytes for the same picture.
//
//   Up to 256 colours become an indexed picture without loss. Each row filter strategy is tried at the best compression and the
//   smallest result is kept. Pixels are 8-bit RGB, row 0 at the top.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace relievo::tb {

struct picture {
  int width = 0;
  int height = 0;
  std::vector<std::array<std::uint8_t, 3>> pixels;  // width * height
};

std::string encode_png(picture const& image);

}  // namespace relievo::tb
