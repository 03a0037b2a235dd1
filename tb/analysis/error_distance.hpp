// error_distance: the error over a curved base, as the distance of each sample's point to the displaced mesh.
//
//   Charts (base triangles connected through equal vertices: P and U) that use the map separately, like the patches of a
//   teapot, are measured each; within a chart a texel counts once.
#pragma once
#include "tb/analysis/error.hpp"

namespace relievo::tb {

error_report measure_distance(surface const& displaced, std::vector<base_corners> const& base, height_map const& map);

}  // namespace relievo::tb
