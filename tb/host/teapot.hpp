// teapot: Newell's patches as a triangle mesh (what base_meshes calls teapot:N).
//
//   u runs along the columns of a patch, v against its rows, which makes n x t point along v everywhere. Points of neighbouring patches are
//   the same bits: a border curve is evaluated from its own four points alone, and the same from either end. Normals that meet at a point
//   within 45 degrees are replaced by their mean, so patches join smoothly. The lid's tip, in the figures a loop a thousandth wide, is one
//   point.
#pragma once
#include "tb/host/mesh.hpp"

namespace relievo::tb {

mesh make_teapot(int quads_per_side);

}  // namespace relievo::tb
