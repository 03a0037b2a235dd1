// hls_maps: the summed-area table and the normal map as the streaming builders of hls/surface make them.
#pragma once
#include <cstdint>
#include <vector>

#include "tb/host/scene.hpp"

namespace relievo::tb {

std::vector<std::uint64_t> build_summed_area_table(scene const& sc);

struct built_normals {
  std::vector<std::uint64_t> words;  // packed, as hls::normal_memory reads them
  std::uint64_t saturations = 0;     // slopes beyond the direction format: 0 for the host's registers
};
built_normals build_normal_map(scene const& sc);

}  // namespace relievo::tb
