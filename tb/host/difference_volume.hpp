// difference_volume: the volume between a displacement map and one of its filter levels, and how it changes with each texel of the level.
//   Gumhold & Huettner 1999, 4.2, eq. 12.
//
//   V     = sum over the map's texels of |level, bilinear - map|, in samples times texels
//   dV_i  = (V_i' - V_i) / (eps A_i): V_i the part of V over the texels that texel i has a weight at, V_i' that with texel i raised by
//           eps, A_i how many they are. The difference quotient itself, with no closed form in its place; 0 <= |dV_i| < 1.
//   One pass over the map gives V and all dV_i: each of the map's texels has a weight at four texels of the level at most.
//   Heights of the level are doubles in samples. No errors.
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "tb/host/level_axis.hpp"
#include "tb/host/map.hpp"

namespace relievo::tb {

class difference_volume {
 public:
  difference_volume(displacement_map const& map, int level)
      : map_(map),
        u_{map.width, level, map.wrap_u},
        v_{map.height, level, map.wrap_v},
        columns_(static_cast<std::size_t>(u_.texels())),
        reached_u_(u_.reached()),
        reached_v_(v_.reached()) {
    for (int x = 0; x < map.width; ++x) across_.push_back(u_.place(x));
  }

  double of(std::vector<double> const& heights) const {
    double volume = 0.0;
    for (int y = 0; y < map_.height; ++y) volume += row_volume(heights, y);
    return volume;
  }

  // V, and dV_i for every texel of the level into `slopes`.
  double with_slopes(std::vector<double> const& heights, double eps, std::vector<double>& slopes) const {
    slopes.assign(heights.size(), 0.0);
    double volume = 0.0;
    for (int y = 0; y < map_.height; ++y) volume += row_slopes(heights, eps, y, slopes);
    std::size_t i = 0;
    for (int down : reached_v_)
      for (int across : reached_u_) slopes[i++] /= eps * down * across;
    return volume;
  }

 private:
  struct row_between {
    std::size_t low, high;
    double part;
  };
  row_between rows_at(int y) const {
    const level_axis::around at = v_.place(y);
    return {at.low * columns_, at.high * columns_, static_cast<double>(at.distance) / v_.spacing()};
  }
  std::uint16_t const* texels_of(int y) const { return map_.texels.data() + static_cast<std::size_t>(y) * across_.size(); }

  // The level between its two rows around y, at its own columns.
  std::vector<double> blended(std::vector<double> const& heights, row_between const& at) const {
    std::vector<double> row(columns_);
    for (std::size_t j = 0; j < columns_; ++j) row[j] = heights[at.low + j] + at.part * (heights[at.high + j] - heights[at.low + j]);
    return row;
  }

  double row_volume(std::vector<double> const& heights, int y) const {
    const std::vector<double> row = blended(heights, rows_at(y));
    std::uint16_t const* texel = texels_of(y);
    const double step = 1.0 / u_.spacing();
    double volume = 0.0;
    for (level_axis::around const& at : across_)
      volume += std::fabs(row[at.low] + at.distance * step * (row[at.high] - row[at.low]) - *texel++);
    return volume;
  }

  double row_slopes(std::vector<double> const& heights, double eps, int y, std::vector<double>& slopes) const {
    const row_between rows = rows_at(y);
    const std::vector<double> row = blended(heights, rows);
    std::uint16_t const* texel = texels_of(y);
    const double step = 1.0 / u_.spacing(), up = rows.part * eps, down = eps - up;
    double* const lower = slopes.data() + rows.low;
    double* const upper = slopes.data() + rows.high;
    double volume = 0.0;
    for (level_axis::around const& at : across_) {
      const double right = at.distance * step, left = 1.0 - right;
      const double above = row[at.low] + right * (row[at.high] - row[at.low]) - *texel++;
      const double part = std::fabs(above);
      volume += part;
      lower[at.low] += std::fabs(above + left * down) - part;
      lower[at.high] += std::fabs(above + right * down) - part;
      upper[at.low] += std::fabs(above + left * up) - part;
      upper[at.high] += std::fabs(above + right * up) - part;
    }
    return volume;
  }

  displacement_map const& map_;
  level_axis u_, v_;
  std::size_t columns_;
  std::vector<int> reached_u_, reached_v_;
  std::vector<level_axis::around> across_;
};

}  // namespace relievo::tb
