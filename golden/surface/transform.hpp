// transform: a displaced point to the screen: view, perspective and viewport in one matrix, then the division by w.
//   P'_s = ((row_x . P' + offset_x) / w, (row_y . P' + offset_y) / w), w = row_w . P' + offset_w
//                                                                                  Doggett & Hirche 2000, section 3
//   in    p        position
//   regs  row_x, row_y  matrix_xy;  row_w  matrix_w;  offset_x, offset_y  offset_xy;  offset_w  offset_w
//         w_min    depth      nearer than this counts as behind the eye
//   out   screen   screen     (0, 0) behind the eye
//         w        depth      0 for a negative sum, which is no saturation
//         behind              w < w_min or w = 0;  saturated: a register clipped, never behind the eye
//   registers: clip (x, y), depth, screen (correctly rounded quotient)
#pragma once
#include <glm/glm.hpp>

#include "golden/core/quotient.hpp"
#include "golden/core/rounding.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct transform_in {
  glm::dvec3 p{0};
  RELIEVO_FIELDS(p)
};
struct transform_regs {
  glm::dvec3 row_x{0}, row_y{0}, row_w{0};
  double offset_x = 0, offset_y = 0, offset_w = 0;
  double w_min = 0;
  RELIEVO_FIELDS(row_x, row_y, row_w, offset_x, offset_y, offset_w, w_min)
};
struct transform_out {
  glm::dvec2 screen{0};
  double w = 0;
  bool behind = false;
  bool saturated = false;
  RELIEVO_FIELDS(screen, w, behind, saturated)
};

template <class Rounding>
transform_out transform(transform_in const& in, transform_regs const& regs) {
  using namespace formats;
  static_assert(fits_double(dot3(bits_of<matrix_xy>(), bits_of<position>()) + bits_of<offset_xy>()), "clip");
  static_assert(fits_double(dot3(bits_of<matrix_w>(), bits_of<position>()) + bits_of<formats::offset_w>()), "depth");
  transform_out out;
  const double sum = glm::dot(regs.row_w, in.p) + regs.offset_w;
  bool clipped = false;
  out.w = sum < 0 ? 0 : Rounding::template at<depth>(sum, clipped);
  out.behind = out.w < regs.w_min || out.w == 0;
  if (out.behind) return out;
  const double x = Rounding::template at<clip>(glm::dot(regs.row_x, in.p) + regs.offset_x, clipped);
  const double y = Rounding::template at<clip>(glm::dot(regs.row_y, in.p) + regs.offset_y, clipped);
  out.screen.x = quotient<Rounding, formats::screen, depth::width>(x, out.w, clipped);
  out.screen.y = quotient<Rounding, formats::screen, depth::width>(y, out.w, clipped);
  out.saturated = clipped;
  return out;
}

}  // namespace golden
}  // namespace relievo
