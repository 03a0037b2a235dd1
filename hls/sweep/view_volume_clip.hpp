// view_volume_clip: is a displaced triangle wholly beyond one plane of the view volume?
//   Gumhold & Huettner 1999, Figure 3; a trivial rejection, clipping proper is the rasteriser's
//   in    screen    screen[3][2], w depth[3], behind[3]: transform's
//   regs  viewport  W, H in pixels, screen;  near, far  depth
//   out   rejected  all w < near, all w > far; where no vertex is behind the eye, which has no place on the screen, also all x < 0,
//                   all x > W, all y < 0 or all y > H
//   registers: none; initiation interval 1
#pragma once
#include "hls/core/fixed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace hls {

struct view_volume_clip_in {
  fixed<formats::screen> screen[3][2];
  fixed<formats::depth> w[3];
  bool behind[3];
  RELIEVO_FIELDS(screen, w, behind)
};
struct view_volume_clip_regs {
  fixed<formats::screen> viewport[2];
  fixed<formats::depth> near;
  fixed<formats::depth> far;
  RELIEVO_FIELDS(viewport, near, far)
};
struct view_volume_clip_out {
  bool rejected;
  RELIEVO_FIELDS(rejected)
};

inline view_volume_clip_out view_volume_clip(view_volume_clip_in const& in, view_volume_clip_regs const& regs) {
  bool low[2] = {true, true}, high[2] = {true, true}, before_near = true, behind_far = true, behind = false;
  for (int i = 0; i < 3; ++i) {
    before_near &= in.w[i] < regs.near;
    behind_far &= in.w[i] > regs.far;
    behind |= in.behind[i];
    for (int axis = 0; axis < 2; ++axis) {
      low[axis] &= raw(in.screen[i][axis]) < 0;
      high[axis] &= in.screen[i][axis] > regs.viewport[axis];
    }
  }
  view_volume_clip_out out;
  out.rejected = before_near || behind_far || (!behind && (low[0] || low[1] || high[0] || high[1]));
  return out;
}

}  // namespace hls
}  // namespace relievo
