// texel_raster: the texel centres that a triangle in texture space covers, borders included, decided exactly.
//
//   Coordinates in texels are brought to a lattice of 2^-16 (the format of U has 11 fractional bits, so its words are met
//   exactly; finer ones move by at most 2^-17 texel, all copies of a vertex alike). With coordinates up to 8192 an edge
//   function stays below 2^61, so int64 decides without rounding: triangles that tile a region leave no centre out.
//   A centre on a shared edge is met by both neighbours; the caller keeps a bitmap when it wants each once.
//
//   raster_texels(corners, visit): visit(i, j, w) with w the three weights (sum 1). Either orientation; no area, no visit.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <utility>

namespace relievo::tb {

namespace raster_detail {

inline constexpr int lattice_bits = 16;
inline constexpr std::int64_t lattice_one = std::int64_t{1} << lattice_bits;

struct point {
  std::int64_t x, y;
};

inline point to_lattice(glm::dvec2 const& u) {
  return {std::llround(u.x * static_cast<double>(lattice_one)), std::llround(u.y * static_cast<double>(lattice_one))};
}

inline std::int64_t floor_div(std::int64_t a, std::int64_t b) {  // b > 0
  return a / b - ((a % b != 0 && a < 0) ? 1 : 0);
}
inline std::int64_t ceil_div(std::int64_t a, std::int64_t b) { return -floor_div(-a, b); }

inline std::int64_t edge_function(point const& a, point const& b, point const& q) {
  return (b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x);
}

}  // namespace raster_detail

template <class Visit>
void raster_texels(std::array<glm::dvec2, 3> const& corners, Visit&& visit) {
  using namespace raster_detail;
  std::array<point, 3> a = {to_lattice(corners[0]), to_lattice(corners[1]), to_lattice(corners[2])};
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::int64_t whole = edge_function(a[0], a[1], a[2]);
  if (whole == 0) return;
  if (whole < 0) {
    std::swap(a[1], a[2]);
    std::swap(order[1], order[2]);
    whole = -whole;
  }
  const auto [lowest, highest] = std::minmax({a[0].y, a[1].y, a[2].y});
  const auto [leftmost, rightmost] = std::minmax({a[0].x, a[1].x, a[2].x});
  for (std::int64_t j = ceil_div(lowest, lattice_one); j <= floor_div(highest, lattice_one); ++j) {
    const std::int64_t y = j * lattice_one;
    std::int64_t from = leftmost;
    std::int64_t to = rightmost;
    for (std::size_t e = 0; e < 3; ++e) {
      point const& p = a[e];
      point const& q = a[(e + 1) % 3];
      const std::int64_t rise = q.y - p.y;
      const std::int64_t c = (q.x - p.x) * (y - p.y);  // inside where rise * (x - p.x) <= c
      if (rise > 0) {
        to = std::min(to, p.x + floor_div(c, rise));
      } else if (rise < 0) {
        from = std::max(from, p.x + ceil_div(-c, -rise));
      } else if (c < 0) {
        to = from - 1;
      }
    }
    for (std::int64_t i = ceil_div(from, lattice_one); i * lattice_one <= to; ++i) {
      const point centre = {i * lattice_one, y};
      glm::dvec3 w;
      for (std::size_t e = 0; e < 3; ++e) {
        const std::size_t opposite = order[(e + 2) % 3];
        w[static_cast<glm::length_t>(opposite)] =
            static_cast<double>(edge_function(a[e], a[(e + 1) % 3], centre)) / static_cast<double>(whole);
      }
      visit(static_cast<int>(i), static_cast<int>(j), w);
    }
  }
}

}  // namespace relievo::tb
