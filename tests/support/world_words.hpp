// world_words: cameras and triangles in the world, as words, and the view volume in long double: what the units before the grid are given.
//
//   view_camera draw_camera(g)      any direction, 10 to 150 degrees, up to 1500 x 1500 pixels, rows times 1 to 1/4; regs: its words
//     clip(p, row), depth(p)        row . p + offset of the words, exact but for long double
//     at(x, y, w)                   the place of these; sees(p)   whether p is in the view volume
//   clip_regs_of(camera)            base_triangle_clip's registers, as a host makes them
//   draw_corner(g, at, size)        a base vertex within `size` of a place, with unit N and T
//   value(x)                        a word's value
#pragma once
#include <array>
#include <cmath>

#include "hls/sweep/world_data.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {

using place = std::array<long double, 3>;

template <class F>
long double value(hls::fixed<F> x) {
  return std::ldexp(static_cast<long double>(raw(x)), -F::fraction);
}
template <class F>
hls::fixed<F> nearest(long double x) {
  const long double scaled = std::floor(std::ldexp(x, F::fraction) + 0.5L);
  const auto low = static_cast<long double>(hls::fixed<F>::min_raw), high = static_cast<long double>(hls::fixed<F>::max_raw);
  return hls::from_raw<F>(static_cast<std::int64_t>(std::min(std::max(scaled, low), high)));
}
template <class F>
place place_of(hls::fixed<F> const (&v)[3]) {
  return {value(v[0]), value(v[1]), value(v[2])};
}
inline long double product(place const& a, place const& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline place moved(place const& p, long double by, place const& along) {
  return {p[0] + by * along[0], p[1] + by * along[1], p[2] + by * along[2]};
}
inline place scaled_to(place const& v, long double length) { return moved({}, length / std::sqrt(product(v, v)), v); }
inline place across(place const& a, place const& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline place draw_place(generator& g, long double within) {
  const auto one = [&] { return within * static_cast<long double>(g.between(-(1 << 24), 1 << 24)) / (1 << 24); };
  return {one(), one(), one()};
}
inline place draw_direction(generator& g) {
  for (;;) {
    const place v = draw_place(g, 1);
    if (product(v, v) > 0.01L && product(v, v) < 1) return scaled_to(v, 1);
  }
}

struct view_camera {
  hls::transform_regs regs{};
  hls::fixed<formats::depth> near, far;
  long double width = 1, height = 1;

  long double clip(place const& p, int axis) const {
    return axis == 0 ? product(place_of(regs.row_x), p) + value(regs.offset_x) : product(place_of(regs.row_y), p) + value(regs.offset_y);
  }
  long double depth(place const& p) const { return product(place_of(regs.row_w), p) + value(regs.offset_w); }
  place at(long double x, long double y, long double w) const {
    const place rows[3] = {place_of(regs.row_x), place_of(regs.row_y), place_of(regs.row_w)};
    const place right = {x - value(regs.offset_x), y - value(regs.offset_y), w - value(regs.offset_w)};
    place p{};
    for (std::size_t i = 0; i < 3; ++i)
      p = moved(p, right[i] / product(rows[0], across(rows[1], rows[2])), across(rows[(i + 1) % 3], rows[(i + 2) % 3]));
    return p;
  }
  bool sees(place const& p) const {
    const long double w = depth(p), x = clip(p, 0), y = clip(p, 1);
    return w >= value(near) && w <= value(far) && x >= 0 && x <= width * w && y >= 0 && y <= height * w;
  }
};

inline view_camera draw_camera(generator& g) {
  const place forward = draw_direction(g), other = draw_direction(g);
  const place side = scaled_to(moved(other, -product(other, forward), forward), 1);
  const place down = across(forward, side);
  view_camera camera;
  camera.width = static_cast<long double>(g.between(1, 1500));
  camera.height = static_cast<long double>(g.between(1, 1500));
  const long double half_angle = static_cast<long double>(g.between(5, 75)) * 3.14159265358979323846L / 180;
  const long double focal = std::min(camera.height / 2 / std::tan(half_angle), 1800.0L);
  const long double scale = std::ldexp(1.0L, -static_cast<int>(g.below(3)));
  const place eye = moved({}, 8 * static_cast<long double>(g.below(3)) / 2, draw_direction(g));
  const auto rows = [&](auto& row, place const& v) {
    for (std::size_t i = 0; i < 3; ++i) row[i] = nearest<typename std::remove_reference_t<decltype(row[0])>::format_type>(scale * v[i]);
  };
  rows(camera.regs.row_x, moved(moved({}, focal, side), camera.width / 2, forward));
  rows(camera.regs.row_y, moved(moved({}, focal, down), camera.height / 2, forward));
  rows(camera.regs.row_w, forward);
  camera.regs.offset_x = nearest<formats::offset_xy>(-product(place_of(camera.regs.row_x), eye));
  camera.regs.offset_y = nearest<formats::offset_xy>(-product(place_of(camera.regs.row_y), eye));
  camera.regs.offset_w = nearest<formats::offset_w>(-product(place_of(camera.regs.row_w), eye));
  camera.regs.w_min = nearest<formats::depth>(std::ldexp(scale, -8));
  const long double near = std::ldexp(scale, -static_cast<int>(g.below(9)));
  camera.near = nearest<formats::depth>(near);
  camera.far = nearest<formats::depth>(near * std::pow(10.0L, static_cast<long double>(g.between(1, 400)) / 100));
  return camera;
}

template <class F>
hls::fixed<F> rounded_up(long double x) {
  return hls::from_raw<F>(static_cast<std::int64_t>(std::ceil(std::ldexp(x * (1 + std::ldexp(1.0L, -13)), F::fraction))));
}
template <class F>
long double length_of(hls::fixed<F> const (&row)[3]) {
  return std::sqrt(product(place_of(row), place_of(row)));
}
inline hls::base_triangle_clip_regs clip_regs_of(view_camera const& camera) {
  hls::base_triangle_clip_regs regs;
  regs.viewport[0] = nearest<formats::screen>(camera.width);
  regs.viewport[1] = nearest<formats::screen>(camera.height);
  regs.reach[0] = rounded_up<formats::reach>(length_of(camera.regs.row_x));
  regs.reach[1] = rounded_up<formats::reach>(length_of(camera.regs.row_y));
  regs.near = camera.near;
  regs.far = camera.far;
  regs.d_scale = rounded_up<formats::matrix_w>(length_of(camera.regs.row_w));
  return regs;
}

inline hls::base_vertex draw_corner(generator& g, place const& at, long double size) {
  hls::base_vertex v{};
  draw_vector(v, g.chance(4) ? draw::corner : draw::uniform, g);
  const place p = moved(at, 1, draw_place(g, size));
  for (std::size_t i = 0; i < 3; ++i) v.p[i] = nearest<formats::position>(p[i]);
  unit_vector(v.n, g);
  unit_vector(v.t, g);
  return v;
}

}  // namespace relievo::test
