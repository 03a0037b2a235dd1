// camera: eye, at, up, vertical field of view and viewport become the registers of transform and transform_normal.
//
//   Screen: x to the right, y down, in pixels; the viewport is [0, width) x [0, height), pixel (i, j) covers [i, i+1) x [j, j+1), its
//   centre is (i + 1/2, j + 1/2). w is the distance from the eye along the line of sight, in engine units times 2^row_exponent: the
//   homogeneous rows and w_min are scaled together by the largest power of two, at most 1, for which no point of the cube [-8, 8)^3
//   saturates clip x, clip y or w. The rotation's rows are the screen's axes: right, down, away from the viewer. near and far take no part
//   in the transform; reports and the rasteriser use them. w_min is 2^-8 engine units (times the power of two). Errors: input_error for
//   what cannot be or does not fit: eye = at, up along the line of sight, an eye too far away, a field of view that magnifies too much.
#pragma once
#include <glm/glm.hpp>

#include "golden/surface/transform.hpp"
#include "golden/surface/transform_normal.hpp"

namespace relievo::tb {

struct camera_view {
  glm::dvec3 eye{0.0}, at{0.0}, up{0.0, 0.0, 1.0};
  double fov_degrees = 40.0;  // vertical
  double near = 0.01, far = 1000.0;
  int width = 1280, height = 720;
};

struct camera_registers {
  golden::transform_regs transform;
  golden::transform_normal_regs transform_normal;
  int row_exponent = 0;
};

// `view` in engine units.
camera_registers make_camera_registers(camera_view const& view);

// Fills eye and at so that the box is seen whole, from a slant.
camera_view look_at_box(camera_view view, glm::dvec3 low, glm::dvec3 high);

}  // namespace relievo::tb
