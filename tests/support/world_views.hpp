// world_views: random cameras with the registers of the units between the world and the grid, and the same in real numbers.
//
//   draw_view(d)                     a camera in or around the cube of positions: near, far, viewport and angle of any size
//   view.real(plane, p)              the distance of near_clip, of the rows as they are, without a register: beyond 2^-60 exact
//   view.tolerance(plane, s)         how far a cut vertex may lie off its plane, and by its own rounding: near_clip.hpp, "a cut vertex
//   lies" view.corner(d)                   a place where planes of the band meet;  draw_triangle_at(d, view) triangles of any size around
//   it
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "golden/sweep/base_triangle_clip.hpp"
#include "golden/sweep/near_clip.hpp"
#include "tb/host/camera.hpp"
#include "tb/host/input_error.hpp"
#include "tests/support/swept_vertices.hpp"

namespace relievo::test {

using real_vector = glm::vec<3, long double>;

inline long double row_sum(glm::dvec3 const& row) { return std::abs(row.x) + std::abs(row.y) + std::abs(row.z); }

struct world_view {
  tb::camera_view camera;
  // w for each world unit
  double scale = 1;
  golden::near_clip_regs clip;
  golden::base_triangle_clip_regs reject;

  golden::transform_regs const& rows() const { return clip.transform; }

  // x, y and w of transform, for each place in the world.
  template <class P>
  real_vector projected(P const& at) const {
    const real_vector p(at);
    const auto sum = [&p](glm::dvec3 const& row, double offset) {
      return glm::dot(real_vector(row), p) + static_cast<long double>(offset);
    };
    return {sum(rows().row_x, rows().offset_x), sum(rows().row_y, rows().offset_y), sum(rows().row_w, rows().offset_w)};
  }
  template <class P>
  long double real(golden::clip_plane plane, P const& at) const {
    const real_vector q = projected(at);
    const long double band = golden::guard_pixels * q.z;
    const long double distances[] = {q.z - clip.near, clip.far - q.z, q.x + band, band - q.x, q.y + band, band - q.y};
    return distances[static_cast<int>(plane)];
  }

  // What half an LSB of position moves the distance by, and what the registers of w, x and y round it by.
  long double half_position(golden::clip_plane plane) const {
    const long double band = golden::guard_pixels * row_sum(rows().row_w);
    const long double sums[] = {row_sum(rows().row_w),        row_sum(rows().row_w),        row_sum(rows().row_x) + band,
                                row_sum(rows().row_x) + band, row_sum(rows().row_y) + band, row_sum(rows().row_y) + band};
    return std::ldexp(sums[static_cast<int>(plane)], -21);
  }
  static long double half_registers(golden::clip_plane plane) {
    return plane <= golden::clip_plane::far ? 0x1p-21L : (golden::guard_pixels + 1) * 0x1p-21L;
  }
  // Off the plane, in real numbers; s is the sum of the distances of the two ends.
  long double tolerance(golden::clip_plane plane, long double s) const {
    return half_registers(plane) + half_position(plane) + std::ldexp(s, -26) + (s >= 32 ? std::ldexp(s, -24) : 0);
  }

  // The place with these x, y in pixels and this w.
  glm::dvec3 place(double x, double y, double w) const {
    const glm::dmat3 matrix = glm::transpose(glm::dmat3(rows().row_x, rows().row_y, rows().row_w));
    return glm::inverse(matrix) * glm::dvec3(x * w - rows().offset_x, y * w - rows().offset_y, w - rows().offset_w);
  }
  glm::dvec3 corner(draw& d) const {
    const double w = d.integer(0, 2) == 0 ? d.real(clip.near, clip.far) : d.coin() ? clip.near : clip.far;
    const auto side = [&d] { return d.integer(0, 2) == 0 ? d.real(-1, 1) : d.coin() ? -1.0 : 1.0; };
    return place(golden::guard_pixels * side(), golden::guard_pixels * side(), w);
  }
};

inline world_view draw_view(draw& d) {
  for (;;) {
    world_view v;
    v.camera.eye = d.direction() * d.real(0, 12);
    v.camera.at = d.direction() * d.real(0.1, 2);
    v.camera.up = d.direction();
    v.camera.fov_degrees = d.coin() ? d.real(20, 90) : std::exp2(d.real(0.1, 7.4));
    v.camera.width = static_cast<int>(std::exp2(d.real(0, 12.99)));
    v.camera.height = static_cast<int>(std::exp2(d.real(0, 12.99)));
    v.camera.near = std::exp2(d.real(-6, 2));
    v.camera.far = v.camera.near * std::exp2(d.real(0.1, 13));
    tb::camera_registers registers;
    try {
      registers = tb::make_camera_registers(v.camera);
    } catch (tb::input_error const&) {
      continue;
    }
    v.scale = std::ldexp(1, registers.row_exponent);
    v.clip.transform = registers.transform;
    // What base_triangle_clip asks of near, and near_clip of w_min.
    const double least = std::max(registers.transform.w_min + 0x1p-16, 0x1p-20 * std::max(v.camera.width, v.camera.height));
    v.clip.near = rounded::at<formats::depth>(std::max(v.camera.near * v.scale, least));
    v.clip.far = rounded::at<formats::depth>(v.camera.far * v.scale);
    if (v.clip.far < v.clip.near + 0x1p-10) continue;
    v.clip.guard = d.integer(0, 4) > 0;

    v.reject.viewport = {v.camera.width, v.camera.height};
    const auto up = [](auto f, double x) {
      const double raised = x * (1 + 0x1p-13);
      const double word = rounded::at<decltype(f)>(raised);
      return word < raised ? word + golden::range_of<decltype(f)>::lsb : word;
    };
    v.reject.reach = {up(formats::reach{}, glm::length(v.rows().row_x)), up(formats::reach{}, glm::length(v.rows().row_y))};
    v.reject.near = v.clip.near;
    v.reject.far = v.clip.far;
    v.reject.d_scale = up(formats::matrix_w{}, glm::length(v.rows().row_w));
    return v;
  }
}

inline glm::dvec3 to_position(glm::dvec3 const& p) {
  return {rounded::at<formats::position>(p.x), rounded::at<formats::position>(p.y), rounded::at<formats::position>(p.z)};
}

// With data of any kind: anywhere, around a corner of the band from a few LSB on, or long and thin.
inline golden::near_clip_in draw_triangle_at(draw& d, world_view const& view) {
  golden::near_clip_in in;
  const glm::dvec3 around = view.corner(d), along = d.direction();
  const double size = std::exp2(d.real(-21, 2));
  const int kind = d.integer(0, 3);
  for (golden::base_vertex& v : in.vertex) {
    v = draw_base_vertex(d);
    const glm::dvec3 off(d.real(-1, 1), d.real(-1, 1), d.real(-1, 1));
    const glm::dvec3 p = kind == 0   ? off * 8.0
                         : kind == 1 ? around + off * size
                         : kind == 2 ? around + along * d.real(-8, 8) + off * size
                                     : around + off * (d.coin() ? size : 8.0);
    v.p = to_position(glm::clamp(p, glm::dvec3(-8), glm::dvec3(8)));
  }
  return in;
}

}  // namespace relievo::test
