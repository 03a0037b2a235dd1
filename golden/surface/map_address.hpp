// map_address: the four texels around a texture coordinate and the place between them.
//   x0 = floor(u), x1 = the next texel, fx = u - floor(u); likewise y. Texel i is a sample at the integer i.
//
//   in   u        coordinate   in texels; [0, W-1] on a clamped axis, [0, W] on a wrapped one
//   out  x0, x1, y0, y1        texel indices; row 0 is v = 0
//        fx, fy                fractions in [0, 1) of 11 bits
//
// clamped: indices stop at W - 1; wrapped: indices are taken modulo W. No register: nothing is rounded.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "golden/surface/map_regs.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct map_address_in {
  glm::dvec2 u{0};
  RELIEVO_FIELDS(u)
};
struct map_address_out {
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  double fx = 0, fy = 0;
  RELIEVO_FIELDS(x0, x1, y0, y1, fx, fy)
};

template <class Rounding>
map_address_out map_address(map_address_in const& in, map_regs const& map) {
  const auto axis = [](double u, int size, bool wrap, int& first, int& second, double& fraction) {
    const double whole = std::floor(u);
    fraction = u - whole;
    const int i = static_cast<int>(whole);
    if (wrap) {
      first = i % size;
      second = (first + 1) % size;
    } else {
      first = std::min(i, size - 1);
      second = std::min(first + 1, size - 1);
    }
  };
  map_address_out out;
  axis(in.u.x, static_cast<int>(map.width), map.wrap_u, out.x0, out.x1, out.fx);
  axis(in.u.y, static_cast<int>(map.height), map.wrap_v, out.y0, out.y1, out.fy);
  return out;
}

}  // namespace golden
}  // namespace relievo
