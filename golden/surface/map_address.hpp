// map_address: the four texels around a texture coordinate and the place between them.
//   x[0] = floor(u), x[1] = the next texel, f = u - floor(u); likewise y. Texel i is a sample at the integer i.
//
//   in   u        coordinate   in texels; [0, W-1] on a clamped axis, [0, W] on a wrapped one
//   out  x[2], y[2]            texel indices; row 0 is v = 0
//        f                     fractions in [0, 1) of 11 bits
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
  int x[2] = {0, 0}, y[2] = {0, 0};
  glm::dvec2 f{0};
  RELIEVO_FIELDS(x, y, f)
};

template <class Rounding>
map_address_out map_address(map_address_in const& in, map_regs const& map) {
  const auto axis = [](double u, int size, bool wrap, int(&cell)[2], double& fraction) {
    const double whole = std::floor(u);
    fraction = u - whole;
    const int i = static_cast<int>(whole);
    if (wrap) {
      cell[0] = i % size;
      cell[1] = (cell[0] + 1) % size;
    } else {
      cell[0] = std::min(i, size - 1);
      cell[1] = std::min(cell[0] + 1, size - 1);
    }
  };
  map_address_out out;
  axis(in.u.x, static_cast<int>(map.width), map.wrap_u, out.x, out.f.x);
  axis(in.u.y, static_cast<int>(map.height), map.wrap_v, out.y, out.f.y);
  return out;
}

}  // namespace golden
}  // namespace relievo
