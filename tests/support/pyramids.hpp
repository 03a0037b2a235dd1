// pyramids: the filter levels of a map that d_max_of reads, as memories and as maps.
#pragma once
#include <vector>

#include "hls/sweep/base_triangle_clip.hpp"
#include "tb/host/level_words.hpp"

namespace relievo::test {

struct pyramids {
  explicit pyramids(tb::displacement_map const& map) {
    regs.width = hls::from_raw<formats::map_size>(map.width);
    regs.height = hls::from_raw<formats::map_size>(map.height);
    regs.wrap_u = map.wrap_u;
    regs.wrap_v = map.wrap_v;
    texels = map.texels;
    for (int level = 0; level < tb::levels_of(map.width, map.height); ++level) {
      highest.push_back(tb::extreme_level(map, level, tb::extreme::maximum));
      lowest.push_back(tb::extreme_level(map, level, tb::extreme::minimum));
      maximum.insert(maximum.end(), highest.back().texels.begin(), highest.back().texels.end());
      minimum.insert(minimum.end(), lowest.back().texels.begin(), lowest.back().texels.end());
    }
  }
  hls::d_max_of_out at(hls::d_max_of_in const& in, hls::displace_regs const& height) const {
    return hls::d_max_of(in, regs, height, {maximum.data()}, {minimum.data()});
  }

  hls::map_regs regs{};
  std::vector<std::uint16_t> texels, maximum, minimum;
  std::vector<tb::displacement_map> highest, lowest;
};

}  // namespace relievo::test
