// level_axis: how filter level l of a displacement map stands along one axis of the map, in whole numbers.
//
//   texels     ceil(size / 2^l); texel j is a sample at the coordinate j 2^l of the map, so U_l = U / 2^l
//   place(x)   the two texels of the level around the map's texel x, as surface/map_address finds them at x / 2^l, and how far x is from
//   the
//              lower one, in map texels. Where both are the same texel (beyond the last one of a clamped axis) the distance is 0.
//   reached()  how many texels of the map have a weight above 0 at each texel of the level
//   On a wrapped axis whose size is no multiple of 2^l the way from the last texel back to texel 0 is cut short at the seam, as the sampler
//   cuts it. x = size is a place of a wrapped axis, texel 0 seen from beyond.
#pragma once
#include <cstddef>
#include <vector>

namespace relievo::tb {

struct level_axis {
  int size = 1;
  int level = 0;
  bool wrap = false;

  struct around {
    std::size_t low = 0, high = 0;
    int distance = 0;
  };

  int spacing() const { return 1 << level; }
  int texels() const { return ((size - 1) >> level) + 1; }

  around place(int x) const {
    const int count = texels();
    const int low = (x >> level) % count;
    const int high = low + 1 < count ? low + 1 : wrap ? 0 : low;
    return {static_cast<std::size_t>(low), static_cast<std::size_t>(high), low == high ? 0 : x & (spacing() - 1)};
  }

  std::vector<int> reached() const {
    std::vector<int> counts(static_cast<std::size_t>(texels()));
    for (int x = 0; x < size; ++x) {
      const around at = place(x);
      ++counts[at.low];
      if (at.distance > 0) ++counts[at.high];
    }
    return counts;
  }
};

// Levels of a map, level 0 and that of one texel included.
inline int levels_of(int width, int height) {
  int count = 1;
  while (((width - 1) >> (count - 1)) > 0 || ((height - 1) >> (count - 1)) > 0) ++count;
  return count;
}

}  // namespace relievo::tb
