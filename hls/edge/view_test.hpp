// view_test: is the edge longer on the screen than the user asks for?
//   vt = |x1 - x2| + |y1 - y2| > vthr                         Doggett & Hirche 2000, 2.4 and 3.1.1
//   in    screen1, screen2  screen[2], pixels, P'_s of the ends;  behind1, behind2  an end at or behind the eye
//   regs  threshold         view_threshold, pixels
//   out   vt                true as well when an end is behind: the other tests decide
//   exact; initiation interval 1
#pragma once
#include "hls/core/fixed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace hls {

struct view_test_in {
  fixed<formats::screen> screen1[2];
  fixed<formats::screen> screen2[2];
  bool behind1;
  bool behind2;
  RELIEVO_FIELDS(screen1, screen2, behind1, behind2)
};
struct view_test_regs {
  fixed<formats::view_threshold> threshold;
  RELIEVO_FIELDS(threshold)
};
struct view_test_out {
  bool vt;
  RELIEVO_FIELDS(vt)
};

inline view_test_out view_test(view_test_in const& in, view_test_regs const& regs) {
  const auto s0_distance = magnitude(in.screen1[0] - in.screen2[0]) + magnitude(in.screen1[1] - in.screen2[1]);
  return {in.behind1 || in.behind2 || s0_distance > regs.threshold};
}

}  // namespace hls
}  // namespace relievo
