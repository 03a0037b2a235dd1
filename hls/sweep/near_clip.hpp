// near_clip: a base triangle cut by near, far and the guard band, so that all of it has w > 0 and, with the guard, a screen position.
//   Ours: Gumhold & Huettner 1999 say nothing of it; Sutherland & Hodgman 1974, plane after plane
//   in    vertex    base_vertex[3]
//   regs  transform rows and offsets (w_min takes no part), near, far depth; guard: the planes of the guard band too
//   out   vertex    base_vertex[9], the polygon, what is beyond `count` is 0; triangle k of its fan: vertex 0, k + 1 and k + 2
//         count     0, or 3 to 9
//         inside    no plane cut anything: the three words as they came;  empty  count is 0
//         overflow  a plane made a tenth vertex, which is left out: only of a polygon thinner than its roundings
//   Planes in this order, distances exact from clip x, y and w (signed clip_depth) of the vertex's words:
//     w - near, far - w, x + 8190 w, 8190 w - x, y + 8190 w, 8190 w - y;  0 is inside
//   Cut of an edge, the same from either end, so that both triangles at it get the same words, whatever their order of corners:
//     r = |da| / (|da| + |db|), both floored to 25 bits by one power of two (ratio, correctly rounded); a + (b - a) r: position,
//     coordinate, colour; N and T to direction, then normalize. r is never a tie, so that of the other end is 1 - r
//   registers: x, y, w, r, each component
//   initiation interval 1 for a triangle that is inside, else a turn for each edge of the polygon and plane: at most 3 + 5 x 9
//   a cut is a quotient, 15 products and two normalize, and 9 products for its x, y and w
#pragma once
#include "hls/core/divide.hpp"
#include "hls/core/normalize.hpp"
#include "hls/core/vector.hpp"
#include "hls/sweep/world_data.hpp"

namespace relievo {
namespace hls {

constexpr int guard_band = 8190;  // pixels to either side of the screen's origin

namespace detail {

using clip_distance = fixed<format<44, 24, true>>;

// A vertex of the polygon, and what its distances are made of.
struct clip_corner {
  base_vertex vertex;
  fixed<formats::clip> x, y;
  fixed<formats::clip_depth> w;
};
struct clip_polygon {
  clip_corner corner[clipped_vertices_max];
  int count;
};

inline clip_corner clip_corner_of(base_vertex const& vertex, transform_regs const& regs) {
  clip_corner corner;
  corner.vertex = vertex;
  corner.x = round_to<formats::clip>(dot(regs.row_x, vertex.p) + regs.offset_x);
  corner.y = round_to<formats::clip>(dot(regs.row_y, vertex.p) + regs.offset_y);
  corner.w = round_to<formats::clip_depth>(dot(regs.row_w, vertex.p) + regs.offset_w);
  return corner;
}

enum clip_plane { clip_near, clip_far, clip_left, clip_right, clip_top, clip_bottom, clip_planes };

inline clip_distance distance_to(int plane, clip_corner const& corner, near_clip_regs const& regs) {
  using common = clip_distance::format_type;
  if (plane == clip_near) return exact_to<common>(corner.w - regs.near);
  if (plane == clip_far) return exact_to<common>(regs.far - corner.w);
  const auto band = corner.w * from_raw<format<13, 13, false>>(guard_band);
  const auto across = plane == clip_left || plane == clip_right ? corner.x : corner.y;
  if (plane == clip_left || plane == clip_top) return exact_to<common>(band + across);
  return exact_to<common>(band - across);
}

// |da| / (|da| + |db|); one of the two is below 0.
inline fixed<formats::ratio> place_of_cut(clip_distance da, clip_distance db) {
  constexpr int kept = 25;
  static_assert(kept <= formats::ratio::fraction, "a tie has a divisor that 2^(fraction + 1) divides, and theirs is below 2^(kept + 1)");
  const std::int64_t a = raw(magnitude(da)), b = raw(magnitude(db)), larger = a > b ? a : b;
  int shift = 0;
  for (int step = 16; step >= 1; step >>= 1)
    if (larger >> (shift + step - 1 + kept) != 0) shift += step;
  const auto near_part = from_raw<format<kept, kept, false>>(a >> shift);
  const auto far_part = from_raw<format<kept, kept, false>>(b >> shift);
  bool clipped = false;
  return divide<formats::ratio>(near_part, near_part + far_part, clipped);
}

template <class To, class From>
inline fixed<To> between(fixed<From> a, fixed<From> b, fixed<formats::ratio> r) {
  const auto sum = a + (b - a) * r;
  static_assert(decltype(sum)::format_type::width <= 53, "golden, which has 53 bits, holds the sum");
  return round_to<To>(sum);
}
inline void direction_between(fixed<formats::unit> (&out)[3], fixed<formats::unit> const (&a)[3], fixed<formats::unit> const (&b)[3],
                              fixed<formats::ratio> r, bool tangent) {
  normalize_in mean;
  mean.tangent = tangent;
  for (int i = 0; i < 3; ++i) mean.v[i] = between<formats::direction>(a[i], b[i], r);
  const normalize_out unit = normalize(mean);
  for (int i = 0; i < 3; ++i) out[i] = unit.n[i];
}

inline base_vertex cut_of(base_vertex const& a, base_vertex const& b, clip_distance da, clip_distance db) {
  const fixed<formats::ratio> r = place_of_cut(da, db);
  base_vertex cut;
  for (int i = 0; i < 3; ++i) cut.p[i] = between<formats::position>(a.p[i], b.p[i], r);
  direction_between(cut.n, a.n, b.n, r, false);
  direction_between(cut.t, a.t, b.t, r, true);
  for (int i = 0; i < 2; ++i) cut.u[i] = between<formats::coordinate>(a.u[i], b.u[i], r);
  for (int i = 0; i < 4; ++i) cut.colour[i] = between<formats::colour>(a.colour[i], b.colour[i], r);
  return cut;
}

inline void put(clip_polygon& polygon, clip_corner const& corner, bool& overflow) {
  if (polygon.count == clipped_vertices_max) {
    overflow = true;
    return;
  }
  polygon.corner[polygon.count] = corner;
  ++polygon.count;
}

// What one plane leaves of the polygon; `cut` where that is less than all.
inline void cut_by(int plane, near_clip_regs const& regs, clip_polygon& polygon, bool& cut, bool& overflow) {
  const clip_polygon before = polygon;
  polygon.count = 0;
  for (int i = 0; i < clipped_vertices_max; ++i) {
    if (i >= before.count) continue;
    const clip_corner &here = before.corner[i], &next = before.corner[i + 1 < before.count ? i + 1 : 0];
    const clip_distance d = distance_to(plane, here, regs), d_next = distance_to(plane, next, regs);
    const bool in = raw(d) >= 0, next_in = raw(d_next) >= 0;
    cut |= !in;
    if (in) put(polygon, here, overflow);
    if (in != next_in) put(polygon, clip_corner_of(cut_of(here.vertex, next.vertex, d, d_next), regs.transform), overflow);
  }
}

}  // namespace detail

inline near_clip_out near_clip(near_clip_in const& in, near_clip_regs const& regs) {
  detail::clip_polygon polygon = {};
  for (int i = 0; i < 3; ++i) polygon.corner[i] = detail::clip_corner_of(in.vertex[i], regs.transform);
  polygon.count = 3;
  bool cut = false;
  near_clip_out out = {};
  out.overflow = false;
  for (int plane = 0; plane < detail::clip_planes; ++plane)
    if (regs.guard || plane < detail::clip_left) detail::cut_by(plane, regs, polygon, cut, out.overflow);
  for (int i = 0; i < clipped_vertices_max; ++i)
    if (i < polygon.count) out.vertex[i] = polygon.corner[i].vertex;
  out.count = from_raw<format<4, 4, false>>(polygon.count);
  out.inside = !cut;
  out.empty = polygon.count == 0;
  return out;
}

}  // namespace hls
}  // namespace relievo
