// summed_area_table: builds the table of Crow's summed areas from a stream of texels, one texel a clock.
//   SAT(x+1, y+1) = sum of D(i, j), i <= x, j <= y, modulo 2^40       Doggett & Hirche 2000, 2.3
//   in    texels row by row from v = 0, x fastest
//   out   one table_sum per texel, in the same order; the exclusive table's row 0 and column 0 are zero and not stored,
//         its last column and row are the totals that a wrapped axis needs
//   state one line of MaxWidth column sums; a map of width x height is done after width * height steps, then the next may begin
//   initiation interval 1
#pragma once
#include "hls/surface/map_regs.hpp"

namespace relievo {
namespace hls {

template <int MaxWidth = 8192>
class summed_area_table {
 public:
  fixed<formats::table_sum> step(fixed<formats::texel> texel, map_regs const& map) {
    const auto above = first_row_ ? from_raw<formats::table_sum>(0) : line_[x_];
    row_ = wrap_to<formats::table_sum>((x_ == 0 ? from_raw<formats::table_sum>(0) : row_) + texel);
    const auto sum = wrap_to<formats::table_sum>(above + row_);
    line_[x_] = sum;
    ++x_;
    if (x_ == raw(map.width)) {
      x_ = 0;
      ++y_;
      first_row_ = y_ == raw(map.height);
      if (first_row_) y_ = 0;
    }
    return sum;
  }

 private:
  fixed<formats::table_sum> line_[MaxWidth];
  fixed<formats::table_sum> row_;
  std::int32_t x_ = 0;
  std::int32_t y_ = 0;
  bool first_row_ = true;
};

}  // namespace hls
}  // namespace relievo
