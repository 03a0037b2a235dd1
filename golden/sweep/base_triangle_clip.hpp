// base_triangle_clip: is a base triangle, however it is displaced, outside the view volume?  Conservative.
//                                                                          Gumhold & Huettner 1999, section 3.3, Figure 9, (7) and (8)
//   rejected when all three corners are beyond one and the same plane of the view volume, moved outward by d_max
//
//   in    screen[3], w[3]   screen, depth    corners in front of the eye (near_clip)
//         d_max    extent         the largest |displacement| on the triangle, world units: d_max_of, or one for the whole map
//   regs  viewport screen         W, H: the view volume is [0, W] x [0, H] in pixels
//         reach    reach          of x and y, pixels times w for each world unit: the lengths of transform's row_x and row_y
//         near, far  depth;  d_scale  matrix_w, w for each world unit: the length of row_w, >= 0
//   out   rejected
//   registers: none, every comparison is exact.  near >= 2^-20 max(W, H)
//
//   K = reach d_max, w_ref the least w; E = K / w_ref + 1 pixel:   x < -E, x > W + E, y < -E, y > H + E     as products, nothing divided
//   d = d_scale d_max:                          w > far + d + 2^-19, w < near - d - 2^-19.  w_ref <= d: never rejected by x or y
//
// Why no visible triangle is lost: a displacement of length d_max moves row_x . P by at most reach d_max = K. Where all corners have
// x < -E, row_x . P < -E w <= -K on the whole triangle, so row_x . P' < 0; likewise (row_x - W row_w) . P' > 0 on the right, as W/2 is in
// the middle and row_x - W row_w is as long as row_x: sqrt(f^2 + (W/2)^2), f / cos of half the horizontal angle, which (7) has.
// The paper takes the vertical angle for x too; where W > H that is not enough. Registers are rounded up, with 2^-13 for normals that are
// rounded themselves; the pixel and the two LSB hold the roundings of screen and w: docs/error_budget.md, "Beyond the view volume".
//
// d_max_of: from the maximum and minimum filter levels: the largest |height| over the texels around the box of coordinates, from at most
// 2 x 2 texels of each. The level is the least one at which the box reaches into at most two texels an axis.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "golden/surface/displace.hpp"
#include "golden/surface/map_regs.hpp"
#include "golden/sweep/world_data.hpp"

namespace relievo {
namespace golden {

// Rounding of the corner's place on the screen, and of its w.
constexpr double side_allowance = 1;
constexpr double depth_allowance = 2 * range_of<formats::depth>::lsb;
// Of the displaced position.
constexpr double extent_allowance = 2 * range_of<formats::extent>::lsb;

template <class Rounding = rounded>
base_triangle_clip_out base_triangle_clip(base_triangle_clip_in const& in, base_triangle_clip_regs const& regs) {
  using namespace formats;
  static_assert(fits_double(bits_of<reach>() * bits_of<extent>()), "K");
  static_assert(fits_double(bits_of<matrix_w>() * bits_of<extent>()), "d");
  static_assert(fits_double((bits_of<screen>() + bits_of<screen>()) * bits_of<depth>()), "a corner beyond a side");
  const auto all = [](auto beyond) { return beyond(0) && beyond(1) && beyond(2); };
  const double d = regs.d_scale * in.d_max;
  if (all([&](int i) { return in.w[i] - regs.far - depth_allowance > d; })) return {true};
  if (all([&](int i) { return regs.near - in.w[i] - depth_allowance > d; })) return {true};
  const double w_ref = std::min({in.w[0], in.w[1], in.w[2]});
  if (w_ref <= d) return {false};
  for (int axis = 0; axis < 2; ++axis) {
    const double k = regs.reach[axis] * in.d_max;
    if (all([&](int i) { return (-in.screen[i][axis] - side_allowance) * w_ref > k; })) return {true};
    if (all([&](int i) { return (in.screen[i][axis] - regs.viewport[axis] - side_allowance) * w_ref > k; })) return {true};
  }
  return {false};
}

// maximum(level, x, y), minimum(level, x, y): texels of the filter levels, level 0 is the map.
template <class Rounding = rounded, class Maximum, class Minimum>
d_max_of_out d_max_of(d_max_of_in const& in, map_regs const& map, displace_regs const& regs, Maximum const& maximum,
                      Minimum const& minimum) {
  int first[2], last[2];
  for (int axis = 0; axis < 2; ++axis) {
    first[axis] = static_cast<int>(std::floor(in.low[axis]));
    last[axis] = static_cast<int>(std::ceil(in.high[axis]));
  }
  int level = 0;
  while ((last[0] >> level) - (first[0] >> level) > 1 || (last[1] >> level) - (first[1] >> level) > 1) ++level;
  const int size[2] = {static_cast<int>(map.width), static_cast<int>(map.height)};
  // On a wrapped axis the coordinate `size` is texel 0 again.
  const auto texel = [&](int axis, int coordinate) { return (coordinate >> level) % (((size[axis] - 1) >> level) + 1); };
  double highest = 0, lowest = range_of<formats::texel>::max;
  for (const int y : {first[1], last[1]})
    for (const int x : {first[0], last[0]}) {
      highest = std::max(highest, static_cast<double>(maximum(level, texel(0, x), texel(1, y))));
      lowest = std::min(lowest, static_cast<double>(minimum(level, texel(0, x), texel(1, y))));
    }
  static_assert(fits_double(bits_of<formats::scale>() * bits_of<formats::sample>() + bits_of<formats::height>()), "height");
  // Rounding is monotonic, so no sample between the two has a larger height.
  const auto height = [&](double sample) { return std::abs(Rounding::template at<formats::height>(regs.scale * sample + regs.bias)); };
  const double d = std::max(height(highest), height(lowest));
  return {Rounding::is_exact ? d : d + extent_allowance};
}

}  // namespace golden
}  // namespace relievo
