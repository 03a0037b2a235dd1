// main_direction: the axis along which an edge is subdivided, and into how many steps.   Gumhold & Huettner 1999, definition 1
//   axis = the one with the largest |difference|, ties x over y over z;  n = that |difference|
//
//   in   p[2]   grid    the ends of the edge, in either order
//   out  axis           0 x, 1 y, 2 z
//        n      steps   vertex i of the edge is p_from + i (p_to - p_from) / n
#pragma once
#include <glm/glm.hpp>

#include "golden/sweep/remeshed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct main_direction_in {
  glm::dvec3 p[2] = {};
  RELIEVO_FIELDS(p)
};
struct main_direction_out {
  int axis = 0;
  double n = 0;
  RELIEVO_FIELDS(axis, n)
};

inline main_direction_out main_direction(main_direction_in const& in) {
  const grid_vector size = glm::abs(grid_vector(in.p[1]) - grid_vector(in.p[0]));
  main_direction_out out;
  for (int axis = 1; axis < 3; ++axis)
    if (size[axis] > size[out.axis]) out.axis = axis;
  out.n = static_cast<double>(size[out.axis]);
  return out;
}

}  // namespace golden
}  // namespace relievo
