#include "tb/host/camera.hpp"

#include <algorithm>
#include <cmath>

#include "tb/host/quantise.hpp"

namespace relievo::tb {

namespace {

constexpr double pi = 3.14159265358979323846;

struct rows {
  glm::dvec3 x{0.0}, y{0.0}, w{0.0};
};

template <class F>
glm::dvec3 quantised(glm::dvec3 v, std::string const& what) {
  return {quantise<F>(v.x, what), quantise<F>(v.y, what), quantise<F>(v.z, what)};
}

// The largest magnitude of row . p + offset over the cube of all positions.
double reach(glm::dvec3 row, double offset) { return 8.0 * (std::abs(row.x) + std::abs(row.y) + std::abs(row.z)) + std::abs(offset); }

template <class F>
bool row_fits(glm::dvec3 row) {
  return fits<F>(row.x) && fits<F>(row.y) && fits<F>(row.z);
}

// Whether the rows times 2^exponent fit their registers, and no sum over the cube saturates.
bool everything_fits(rows const& r, glm::dvec3 eye, int exponent) {
  using namespace formats;
  const double k = std::ldexp(1.0, exponent);
  const double ox = -glm::dot(r.x, eye) * k, oy = -glm::dot(r.y, eye) * k, ow = -glm::dot(r.w, eye) * k;
  const double most_clip = max_of<clip>() - 1.0, most_depth = max_of<depth>() - 1.0;
  return row_fits<matrix_xy>(r.x * k) && row_fits<matrix_xy>(r.y * k) && row_fits<matrix_w>(r.w * k) && fits<offset_xy>(ox) &&
         fits<offset_xy>(oy) && fits<offset_w>(ow) && reach(r.x * k, ox) < most_clip && reach(r.y * k, oy) < most_clip &&
         reach(r.w * k, ow) < most_depth;
}

void check_lens(camera_view const& view) {
  if (!(view.fov_degrees >= 0.1 && view.fov_degrees <= 175.0))
    throw input_error("--fov: " + shown(view.fov_degrees) + " degrees; from 0.1 to 175 is possible");
  if (view.width < 1 || view.height < 1 || view.width > 8191 || view.height > 8191)
    throw input_error("--viewport: " + std::to_string(view.width) + "x" + std::to_string(view.height) +
                      "; from 1x1 to 8191x8191 is possible");
}

void check_place(camera_view const& view) {
  for (int i = 0; i < 3; ++i)
    if (!std::isfinite(view.eye[i]) || !std::isfinite(view.at[i]) || !std::isfinite(view.up[i]))
      throw input_error("--eye, --at, --up: finite numbers are needed");
  if (!(view.near > 0.0 && view.far > view.near && std::isfinite(view.far))) throw input_error("--near, --far: 0 < near < far is needed");
}

}  // namespace

camera_registers make_camera_registers(camera_view const& view) {
  using namespace formats;
  check_lens(view);
  check_place(view);
  const glm::dvec3 sight = view.at - view.eye;
  if (!(glm::length(sight) > 1e-9)) throw input_error("--eye, --at: the eye looks at itself; two different points are needed");
  const glm::dvec3 forward = glm::normalize(sight);
  const glm::dvec3 side = glm::cross(forward, view.up);
  if (!(glm::length(side) > 1e-6 * glm::length(view.up)) || !(glm::length(view.up) > 0.0))
    throw input_error("--up: lies along the line of sight; another direction is needed");
  const glm::dvec3 right = glm::normalize(side), down = glm::cross(forward, right);
  const double focal = 0.5 * view.height / std::tan(view.fov_degrees * pi / 360.0);

  rows r;
  r.x = right * focal + forward * (0.5 * view.width);
  r.y = down * focal + forward * (0.5 * view.height);
  r.w = forward;
  camera_registers out;
  // Below 2^-12, w_min would be nothing.
  constexpr int least = -12;
  while (out.row_exponent >= least && !everything_fits(r, view.eye, out.row_exponent)) --out.row_exponent;
  if (out.row_exponent < least)
    throw input_error(
        "--eye, --fov, --viewport: the view does not fit the registers; a nearer eye, a wider field of view or a smaller viewport is "
        "needed");
  const double k = std::ldexp(1.0, out.row_exponent);
  golden::transform_regs& t = out.transform;
  t.row_x = quantised<matrix_xy>(r.x * k, "view matrix, row x");
  t.row_y = quantised<matrix_xy>(r.y * k, "view matrix, row y");
  t.row_w = quantised<matrix_w>(r.w * k, "view matrix, row w");
  // From the rounded rows, so that a point at the eye has exactly w = 0, x = 0, y = 0 but for the offset's own rounding.
  t.offset_x = quantise<offset_xy>(-glm::dot(t.row_x, view.eye), "view matrix, offset x");
  t.offset_y = quantise<offset_xy>(-glm::dot(t.row_y, view.eye), "view matrix, offset y");
  t.offset_w = quantise<offset_w>(-glm::dot(t.row_w, view.eye), "view matrix, offset w");
  t.w_min = quantise<depth>(std::ldexp(1.0, -8) * k, "w_min");
  golden::transform_normal_regs& n = out.transform_normal;
  n.rotation[0] = quantised<unit>(right, "rotation");
  n.rotation[1] = quantised<unit>(down, "rotation");
  n.rotation[2] = quantised<unit>(forward, "rotation");
  n.eye = quantised<formats::eye>(view.eye, "--eye (in engine units)");
  return out;
}

camera_view look_at_box(camera_view view, glm::dvec3 low, glm::dvec3 high) {
  check_lens(view);
  const glm::dvec3 up = glm::length(view.up) > 0.0 ? glm::normalize(view.up) : glm::dvec3(0, 0, 1);
  // 35 degrees above the horizon that `up` gives, a little to the right of the axis that is least along it.
  const glm::dvec3 a = glm::abs(up);
  const glm::dvec3 axis = a.y <= a.x && a.y <= a.z ? glm::dvec3(0, -1, 0) : a.x <= a.z ? glm::dvec3(-1, 0, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 front = glm::normalize(axis - up * glm::dot(axis, up)), side = glm::cross(up, front);
  const glm::dvec3 horizontal = front * std::cos(0.4) + side * std::sin(0.4);
  const double height = 35.0 * pi / 180.0;
  const glm::dvec3 toward_eye = horizontal * std::cos(height) + up * std::sin(height);
  const glm::dvec3 right = glm::normalize(glm::cross(up, toward_eye)), over = glm::cross(toward_eye, right);
  const double tan_v = std::tan(view.fov_degrees * pi / 360.0), tan_h = tan_v * view.width / view.height;
  const glm::dvec3 half = glm::max(0.5 * (high - low), glm::dvec3(1e-9));
  // As near as lets every corner fall inside, and a twentieth more.
  double distance = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 q = half * glm::dvec3((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
    const double sideways = std::fmax(std::abs(glm::dot(q, right)) / tan_h, std::abs(glm::dot(q, over)) / tan_v);
    distance = std::fmax(distance, glm::dot(q, toward_eye) + sideways);
  }
  view.at = 0.5 * (low + high);
  view.eye = view.at + toward_eye * (1.05 * distance);
  return view;
}

}  // namespace relievo::tb
