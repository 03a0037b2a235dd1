// transform: a world position to the screen: view, perspective and viewport in one matrix and one division.
//   (x, y, w) = M (P', 1);  P'_s = (x/w, y/w)                Doggett & Hirche 2000, section 3, Transform
//   in    p        position[3]
//   regs  row_x, row_y, row_w, their offsets, w_min          the host may scale all three rows by one power of two
//   out   screen   screen[2], pixels; w depth
//         behind   w < w_min, or w = 0 whatever w_min: at or behind the eye plane, then screen is (0, 0)
//         saturated  a register clipped (the engine counts these apart: far off the screen is no fault of a scene)
//   registers: s0_x, s0_y (clip), w (depth; a negative sum is 0 and does not count), screen: quotients correctly rounded
//   initiation interval 1
#pragma once
#include "hls/core/divide.hpp"
#include "hls/core/record.hpp"
#include "hls/core/vector.hpp"

namespace relievo {
namespace hls {

struct transform_in {
  fixed<formats::position> p[3];
  RELIEVO_FIELDS(p)
};
struct transform_regs {
  fixed<formats::matrix_xy> row_x[3];
  fixed<formats::matrix_xy> row_y[3];
  fixed<formats::matrix_w> row_w[3];
  fixed<formats::offset_xy> offset_x;
  fixed<formats::offset_xy> offset_y;
  fixed<formats::offset_w> offset_w;
  fixed<formats::depth> w_min;
  RELIEVO_FIELDS(row_x, row_y, row_w, offset_x, offset_y, offset_w, w_min)
};
struct transform_out {
  fixed<formats::screen> screen[2];
  fixed<formats::depth> w;
  bool behind;
  bool saturated;
  RELIEVO_FIELDS(screen, w, behind, saturated)
};

inline transform_out transform(transform_in const& in, transform_regs const& regs) {
  transform_out out;
  out.saturated = false;
  const auto s0_sum_w = dot(regs.row_w, in.p) + regs.offset_w;
  static_assert(decltype(s0_sum_w)::format_type::width <= 53, "golden, which has 53 bits, holds the sum");
  bool w_clipped = false;
  out.w = round_to<formats::depth>(s0_sum_w, w_clipped);
  out.behind = out.w < regs.w_min || raw(out.w) == 0;
  const auto s0_x = round_to<formats::clip>(dot(regs.row_x, in.p) + regs.offset_x, out.saturated);
  const auto s0_y = round_to<formats::clip>(dot(regs.row_y, in.p) + regs.offset_y, out.saturated);
  out.saturated |= w_clipped;
  out.screen[0] = divide<formats::screen>(s0_x, out.w, out.saturated);
  out.screen[1] = divide<formats::screen>(s0_y, out.w, out.saturated);
  if (out.behind) {
    out.screen[0] = from_raw<formats::screen>(0);
    out.screen[1] = from_raw<formats::screen>(0);
    out.saturated = false;
  }
  return out;
}

}  // namespace hls
}  // namespace relievo
