// summed_area_table: SAT(x, y) = sum of the texels [0, x) x [0, y), modulo 2^40.   Doggett & Hirche 2000, section 2.3; Crow 1984
//
//   in   texels        W*H stored displacements, row 0 is v = 0, x fastest
//   out  W*H words     table_sum, in the same order; word (x, y) is SAT(x+1, y+1), the sum up to and including texel (x, y)
//
// The table is exclusive: SAT(0, .) = SAT(., 0) = 0 are not stored. Sums of rectangles stay right modulo 2^40.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hls/core/formats.hpp"

namespace relievo {
namespace golden {

constexpr std::uint64_t table_mask = (std::uint64_t{1} << formats::table_sum::width) - 1;

inline std::vector<std::uint64_t> summed_area_table(std::uint16_t const* texels, int width, int height) {
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  std::vector<std::uint64_t> table(w * h);
  for (std::size_t y = 0; y < h; ++y) {
    std::uint64_t row = 0;
    for (std::size_t x = 0; x < w; ++x) {
      row += texels[y * w + x];
      table[y * w + x] = ((y > 0 ? table[(y - 1) * w + x] : 0) + row) & table_mask;
    }
  }
  return table;
}

}  // namespace golden
}  // namespace relievo
