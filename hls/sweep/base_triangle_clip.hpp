// base_triangle_clip: is all of a triangle, displaced by up to d_max, outside of the view volume?
//   Gumhold & Huettner 1999, 3.3, Figure 9, equations (7) and (8); conservative, nothing divided
//   in    screen    screen[3][2], w depth[3], > 0: transform's, of the corners;  d_max extent: of d_max_of, or of the whole map
//   regs  viewport  W, H in pixels, screen;  near, far depth
//         reach     of x and y: clip x (clip y) moves by at most that for each world unit: the length of the matrix row, rounded up
//         d_scale   w for each world unit, rounded up, matrix_w, not below 0
//   out   rejected
//   With K = reach d_max, d = d_scale d_max and the smallest w, w_ref: all three corners beyond the same of
//     x < -E, x > W + E, y < -E, y > H + E, E = K / w_ref + 1, where w_ref > d;  w > far + d + e, w < near - d - e, e = 2^-19
//   Beyond a side: with (x + 1) w_ref < -K at all corners, x w < -K - w there, as w >= w_ref; clip x = x w is linear over the triangle,
//   and a point displaced by h N from it has x w + h (row_x . N) < 0. The pixel is for the roundings of screen, clip and w, which is enough
//   while near >= 2^-20 max(W, H); e for those of w and of the displaced position. So nothing that can be seen is rejected:
//   docs/error_budget.md, "Beyond the view volume".
//   registers: none; all exact; 15 products; initiation interval 1
//
// d_max_of: the largest |displacement| of a box of the map, from the filter levels of its maxima and minima
//   in    low, high coordinate[2] each, low <= high: of the samples themselves, without what a filter adds around them
//   regs  map; displace_regs;  memories maximum, minimum (level_memory)
//   out   d_max     extent: the larger of |scale max + bias| and |scale min + bias|, each rounded to height, and 2 LSB
//   The lowest level at which the box has at most two columns and two rows of texels: at most 2 x 2 of them are read in each memory. Texel
//   j of level l bounds all of the map from j 2^l up to (j + 1) 2^l, so those under the box's ends bound what is between.
//   initiation interval 4 from one port each
#pragma once
#include "hls/surface/displace.hpp"
#include "hls/surface/map_regs.hpp"
#include "hls/sweep/world_data.hpp"

namespace relievo {
namespace hls {

// The levels one after the other, from level 0, which is the map, to that of one texel; each of ceil(W / 2^l) x ceil(H / 2^l) texels, row
// by row from v = 0.
struct level_memory {
  std::uint16_t const* words;
};

namespace detail {

using one_pixel = fixed<format<1, 1, false>>;

// x < -E of a side, as products; `beyond` is how far x lies outside of it.
template <class Beyond, class Reach>
inline bool beyond_side(fixed<Beyond> beyond, fixed<formats::depth> w_ref, fixed<Reach> k) {
  const auto product = (beyond - from_raw<one_pixel::format_type>(1)) * w_ref;
  static_assert(decltype(product)::format_type::width <= 53 && Reach::width <= 53, "golden, which has 53 bits, holds either side");
  return product > k;
}

}  // namespace detail

inline base_triangle_clip_out base_triangle_clip(base_triangle_clip_in const& in, base_triangle_clip_regs const& regs) {
  const auto lower = in.w[0] < in.w[1] ? in.w[0] : in.w[1];
  const auto w_ref = lower < in.w[2] ? lower : in.w[2];
  const auto d = regs.d_scale * in.d_max;
  bool low[2] = {true, true}, high[2] = {true, true}, before_near = true, behind_far = true;
  for (int axis = 0; axis < 2; ++axis) {
    const auto k = regs.reach[axis] * in.d_max;
    for (int i = 0; i < 3; ++i) {
      low[axis] &= detail::beyond_side(-in.screen[i][axis], w_ref, k);
      high[axis] &= detail::beyond_side(in.screen[i][axis] - regs.viewport[axis], w_ref, k);
    }
  }
  const auto margin = d + from_raw<format<2, -18, false>>(2);
  for (int i = 0; i < 3; ++i) {
    before_near &= regs.near - in.w[i] > margin;
    behind_far &= in.w[i] - regs.far > margin;
  }
  base_triangle_clip_out out;
  out.rejected = (w_ref > d && (low[0] || high[0] || low[1] || high[1])) || before_near || behind_far;
  return out;
}

inline d_max_of_out d_max_of(d_max_of_in const& in, map_regs const& map, displace_regs const& regs, level_memory const& maximum,
                             level_memory const& minimum) {
  const std::int64_t size[2] = {raw(map.width), raw(map.height)};
  std::int64_t first[2], last[2];
  for (int axis = 0; axis < 2; ++axis) {
    first[axis] = floor_int(in.low[axis]);
    last[axis] = -floor_int(-in.high[axis]);
  }
  // s0: the level, its texels under the ends of the box, and where it begins in the memories.
  constexpr int levels = formats::map_size::width;
  std::int64_t count[2] = {size[0], size[1]}, begin = 0;
  for (int level = 1; level < levels; ++level) {
    if (last[0] - first[0] <= 1 && last[1] - first[1] <= 1) continue;
    if (count[0] == 1 && count[1] == 1) continue;
    begin += count[0] * count[1];
    for (int axis = 0; axis < 2; ++axis) {
      count[axis] = (count[axis] + 1) >> 1;
      first[axis] >>= 1;
      last[axis] >>= 1;
    }
  }
  std::uint16_t most = 0, least = 0xffff;
  for (int corner = 0; corner < 4; ++corner) {
    const std::int64_t column = corner % 2 == 0 ? first[0] : last[0], row = corner / 2 == 0 ? first[1] : last[1];
    const std::int64_t word = begin + (row < count[1] ? row : row - count[1]) * count[0] + (column < count[0] ? column : column - count[0]);
    const std::uint16_t above = maximum.words[word], below = minimum.words[word];
    most = above > most ? above : most;
    least = below < least ? below : least;
  }
  // s1: height, as displace rounds it; rising or falling with the texel, by the sign of the scale.
  const auto s1_most = magnitude(round_to<formats::height>(regs.scale * from_raw<formats::texel>(most) + regs.bias));
  const auto s1_least = magnitude(round_to<formats::height>(regs.scale * from_raw<formats::texel>(least) + regs.bias));
  d_max_of_out out;
  out.d_max = round_to<formats::extent>((s1_most > s1_least ? s1_most : s1_least) + from_raw<format<2, -18, false>>(2));
  return out;
}

}  // namespace hls
}  // namespace relievo
