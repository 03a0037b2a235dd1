// view_volume_clip: is a displaced triangle wholly beyond one plane of the view volume? Clipping proper is the rasteriser's.
//                                                                                        Gumhold & Huettner 1999, Figure 3
//   in    screen[3], w[3], behind[3]   of transform
//   regs  viewport screen   W, H: the view volume is [0, W] x [0, H] in pixels;  near, far depth
//   out   rejected   all w < near, all w > far, or with no vertex behind the eye all x < 0, all x > W, all y < 0, all y > H
//   registers: none
#pragma once
#include <glm/glm.hpp>

#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct view_volume_clip_in {
  glm::dvec2 screen[3] = {};
  double w[3] = {0, 0, 0};
  bool behind[3] = {false, false, false};
  RELIEVO_FIELDS(screen, w, behind)
};
struct view_volume_clip_regs {
  glm::dvec2 viewport{0};
  double near = 0;
  double far = 0;
  RELIEVO_FIELDS(viewport, near, far)
};
struct view_volume_clip_out {
  bool rejected = false;
  RELIEVO_FIELDS(rejected)
};

inline view_volume_clip_out view_volume_clip(view_volume_clip_in const& in, view_volume_clip_regs const& regs) {
  const auto all = [](auto beyond) { return beyond(0) && beyond(1) && beyond(2); };
  if (all([&](int i) { return in.w[i] < regs.near; }) || all([&](int i) { return in.w[i] > regs.far; })) return {true};
  // What is behind the eye has no place on the screen.
  if (in.behind[0] || in.behind[1] || in.behind[2]) return {false};
  for (int axis = 0; axis < 2; ++axis)
    if (all([&](int i) { return in.screen[i][axis] < 0; }) || all([&](int i) { return in.screen[i][axis] > regs.viewport[axis]; }))
      return {true};
  return {false};
}

}  // namespace golden
}  // namespace relievo
