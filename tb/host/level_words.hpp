// level_words: averaged, maximum and minimum filter levels, each made of the map itself.
//
//   averaged_level  the mean over the texel's cell: the texels of the map that are nearer to it than to the next texels of the level, those
//                   half-way with half a weight (a box of side 2^l around j 2^l; at a clamped border it is cut, and the last one reaches
//                   to the border). Exact sums, rounded once, halves up.
//   extreme_level   the largest (smallest) texel of the map wherever the level's texel has a weight above 0, which is more than its cell:
//   the
//                   level, bilinear, lies nowhere below (above) the map, and no level below (above) a finer one but where a seam is cut
//                   short (level_axis.hpp). On a wrapped axis the seam from beyond, x = size, is such a place too.
//   On wrapped axes both reach over the seam. Level 0 is the map.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "tb/host/level_axis.hpp"
#include "tb/host/map.hpp"

namespace relievo::tb {

// A level of `map` without its texels.
inline displacement_map empty_level(displacement_map const& map, int level) {
  displacement_map out;
  out.width = level_axis{map.width, level, map.wrap_u}.texels();
  out.height = level_axis{map.height, level, map.wrap_v}.texels();
  out.wrap_u = map.wrap_u;
  out.wrap_v = map.wrap_v;
  out.name = map.name;
  out.range = map.range;
  return out;
}

// Calls use(texel of the level, weight in halves) for the cells that x is in.
template <class Use>
void for_cells(level_axis const& axis, int x, Use const& use) {
  const level_axis::around at = axis.place(x);
  const int twice = 2 * at.distance;
  if (twice <= axis.spacing()) use(at.low, twice == axis.spacing() ? 1u : 2u);
  if (twice >= axis.spacing()) use(at.high, twice == axis.spacing() ? 1u : 2u);
}

inline displacement_map averaged_level(displacement_map const& map, int level) {
  const level_axis u{map.width, level, map.wrap_u}, v{map.height, level, map.wrap_v};
  displacement_map out = empty_level(map, level);
  const auto columns = static_cast<std::size_t>(out.width);
  std::vector<std::uint64_t> sums(columns * static_cast<std::size_t>(out.height)), weights_u(columns), weights_v(sums.size() / columns);
  for (int x = 0; x < map.width; ++x) for_cells(u, x, [&](std::size_t j, unsigned w) { weights_u[j] += w; });
  for (int y = 0; y < map.height; ++y) {
    std::vector<std::uint64_t> row(columns);
    for (int x = 0; x < map.width; ++x) for_cells(u, x, [&](std::size_t j, unsigned w) { row[j] += w * map.at(x, y); });
    for_cells(v, y, [&](std::size_t i, unsigned w) {
      weights_v[i] += w;
      for (std::size_t j = 0; j < columns; ++j) sums[i * columns + j] += w * row[j];
    });
  }
  for (std::size_t i = 0; i < weights_v.size(); ++i)
    for (std::size_t j = 0; j < columns; ++j) {
      const std::uint64_t weight = weights_v[i] * weights_u[j];
      out.texels.push_back(static_cast<std::uint16_t>((2 * sums[i * columns + j] + weight) / (2 * weight)));
    }
  return out;
}

enum class extreme { minimum, maximum };

inline displacement_map extreme_level(displacement_map const& map, int level, extreme which) {
  const level_axis u{map.width, level, map.wrap_u}, v{map.height, level, map.wrap_v};
  const auto take = [which](std::uint16_t& to, std::uint16_t value) {
    to = which == extreme::maximum ? std::max(to, value) : std::min(to, value);
  };
  const std::uint16_t none = which == extreme::maximum ? 0 : 0xffff;
  // A texel of the level has a weight at x when x lies at it, or on the way to it.
  const auto for_weighted = [](level_axis const& axis, int x, auto const& use) {
    const level_axis::around at = axis.place(x);
    use(at.low);
    if (at.distance > 0) use(at.high);
  };
  displacement_map out = empty_level(map, level);
  const auto columns = static_cast<std::size_t>(out.width);
  out.texels.assign(columns * static_cast<std::size_t>(out.height), none);
  for (int y = 0; y < map.height + (map.wrap_v ? 1 : 0); ++y) {
    std::vector<std::uint16_t> row(columns, none);
    for (int x = 0; x < map.width + (map.wrap_u ? 1 : 0); ++x) {
      const std::uint16_t value = map.at(x % map.width, y % map.height);
      for_weighted(u, x, [&](std::size_t j) { take(row[j], value); });
    }
    for_weighted(v, y, [&](std::size_t i) {
      for (std::size_t j = 0; j < columns; ++j) take(out.texels[i * columns + j], row[j]);
    });
  }
  return out;
}

}  // namespace relievo::tb
