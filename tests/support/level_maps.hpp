// level_maps: small displacement maps with every address mode, and a filter level by its definition: where its texels stand in the map, and
// its bilinear height, by surface/map_sampler. Nothing of tb/host/level_axis.hpp.
#pragma once
#include <cmath>
#include <cstdlib>
#include <vector>

#include "golden/surface/map_sampler.hpp"
#include "tb/host/map.hpp"
#include "tests/support/random.hpp"

namespace relievo::test {

inline tb::displacement_map level_map(int width, int height, int wrap, std::uint64_t bits, generator& g) {
  tb::displacement_map map;
  map.width = width;
  map.height = height;
  map.wrap_u = (wrap & 1) != 0;
  map.wrap_v = (wrap & 2) != 0;
  map.name = "random";
  for (int i = 0; i < width * height; ++i) map.texels.push_back(static_cast<std::uint16_t>(g.below(std::uint64_t(1) << bits)));
  return map;
}

// Rough maps of odd and even sizes, each axis clamped and wrapped: use(map).
template <class Use>
void for_level_maps(char const* salt, Use const& use) {
  generator g(salt);
  constexpr int sizes[][2] = {{1, 1}, {2, 1}, {1, 3}, {4, 4}, {5, 3}, {7, 7}, {8, 6}, {9, 13}, {16, 16}, {17, 11}, {31, 20}};
  for (auto const& size : sizes)
    for (int wrap = 0; wrap < 4; ++wrap) use(level_map(size[0], size[1], wrap, 16, g));
}

// The texels of a level along an axis and their places: 0, s, 2 s .. below the size; on a wrapped axis the next one is texel 0 again.
struct standing {
  int texel, place;
};
inline std::vector<standing> standings(int size, int level, bool wrap) {
  std::vector<standing> all;
  const int s = 1 << level;
  int at = 0;
  for (; at < size; at += s) all.push_back({at / s, at});
  if (wrap) all.push_back({0, at});
  return all;
}
inline int level_size(int size, int level) { return static_cast<int>(std::ceil(size / std::ldexp(1.0, level))); }

// The level's height at x, y of its map.
template <class Height>
double level_at(tb::displacement_map const& map, int level, int x, int y, Height const& height) {
  const int width = level_size(map.width, level), rows = level_size(map.height, level);
  const golden::map_regs regs{static_cast<double>(width), static_cast<double>(rows), map.wrap_u, map.wrap_v};
  return golden::map_sampler<golden::exact>(
             {{std::ldexp(x, -level), std::ldexp(y, -level)}}, regs,
             [&](int i, int j) { return static_cast<double>(height[static_cast<std::size_t>(j * width + i)]); })
      .d;
}

template <class Height>
double volume_by_definition(tb::displacement_map const& map, int level, Height const& height) {
  double volume = 0.0;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) volume += std::fabs(level_at(map, level, x, y, height) - map.at(x, y));
  return volume;
}

}  // namespace relievo::test
