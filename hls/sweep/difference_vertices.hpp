// difference_vertices: what the data of a vertex changes by in a step along an edge, along the sweep and along the side.
//   D_edge  = (V_1 - V_0) / n                                   Gumhold & Huettner 1999, 3.4.2, equations (9) to (11)
//   D_sweep = (dV_AB dt_AC - dV_AC dt_AB) / det,  D_side = (dV_AC ds_AB - dV_AB ds_AC) / det,  det = ds_AB dt_AC - ds_AC dt_AB
//   in    p       grid[3][3];  plane  from remeshing_plane
//         corner  interpolants[3] of the triangle's block
//         end     interpolants[3][2] of each edge's own block: edge e joins the corners e and (e+1) mod 3; [0] is its canonical end,
//                 the one with the lower main coordinate, without steps corner e
//   out   edge[3], sweep, side  vertex_steps, correctly rounded (half up); edge[e] is 0 where the edge has no steps,
//         sweep and side where |det| <= n, steps of the primary edge: no grid vertex occurs then
//   The numerators times 2^16 are below 2^61. Results are below 2^45: the primary edge is the longest of all, as an edge that is longer
//   than any primary one would be primary; so |dt| and |ds| are at most n, and |det| is above n.
//   80 quotients a triangle; initiation interval 1
#pragma once
#include "hls/core/divide.hpp"
#include "hls/sweep/main_direction.hpp"
#include "hls/sweep/remeshing_plane.hpp"
#include "hls/sweep/vertex_data.hpp"

namespace relievo {
namespace hls {

struct difference_vertices_in {
  fixed<formats::grid> p[3][3];
  remeshing_plane_out plane;
  interpolants corner[3];
  interpolants end[3][2];
  RELIEVO_FIELDS(p, plane, corner, end)
};
struct difference_vertices_out {
  vertex_steps edge[3];
  vertex_steps sweep;
  vertex_steps side;
  RELIEVO_FIELDS(edge, sweep, side)
};

namespace detail {

// The main direction and the steps of an edge of the triangle.
inline main_direction_out main_direction_of(fixed<formats::grid> const (&p)[3][3], int from, int to) {
  main_direction_in ends;
  for (int axis = 0; axis < 3; ++axis) {
    ends.p[0][axis] = p[from][axis];
    ends.p[1][axis] = p[to][axis];
  }
  return main_direction(ends);
}

template <class To, class N>
inline fixed<To> step_of(fixed<N> numerator, std::int64_t denominator) {
  static_assert(is_step_of<To, N>(), "the guard bits");
  static_assert(N::width + guard_bits + 1 <= 64, "an intermediate is wider than 64 bits");
  const std::int64_t quotient = rounded_quotient(raw(numerator) * (std::int64_t(1) << guard_bits), denominator);
  return wrap_to<To>(from_raw<format<64, 64 - To::fraction, true>>(quotient));
}

struct edge_difference {
  std::int64_t n;
  template <class To, class From>
  void operator()(fixed<To>& out, fixed<From> const& begin, fixed<From> const& end) const {
    out = n == 0 ? from_raw<To>(0) : step_of<To>(end - begin, n);
  }
};

using grid_difference = fixed<format<17, 17, true>>;

// (dV_AB ab + dV_AC ac) / det with det > 0.
struct plane_difference {
  grid_difference ab, ac;
  std::int64_t det;
  template <class To, class From>
  void operator()(fixed<To>& out, fixed<From> const& a, fixed<From> const& b, fixed<From> const& c) const {
    out = step_of<To>((b - a) * ab + (c - a) * ac, det);
  }
};

}  // namespace detail

inline difference_vertices_out difference_vertices(difference_vertices_in const& in) {
  using detail::of;
  difference_vertices_out out;
  for (int e = 0; e < 3; ++e) {
    const std::int64_t n = raw(detail::main_direction_of(in.p, e, detail::after(e)).n);
    for_components(detail::edge_difference{n}, out.edge[e], in.end[e][0], in.end[e][1]);
  }

  const int a = of(in.plane.a), b = of(in.plane.b), c = of(in.plane.c), s = of(in.plane.s), t = of(in.plane.t);
  const auto ds_ab = in.p[b][s] - in.p[a][s], dt_ab = in.p[b][t] - in.p[a][t];
  const auto ds_ac = in.p[c][s] - in.p[a][s], dt_ac = in.p[c][t] - in.p[a][t];
  // Left at 0.
  if (magnitude(in.plane.det) <= magnitude(ds_ab)) return out;

  // The divisor is positive: its sign goes to the differences.
  const bool negative = in.plane.det < from_raw<format<1, 1, false>>(0);
  const std::int64_t det = negative ? -raw(in.plane.det) : raw(in.plane.det);
  using detail::grid_difference;
  const auto turned = [negative](grid_difference difference, bool minus) {
    return from_raw<grid_difference::format_type>(negative != minus ? -raw(difference) : raw(difference));
  };
  const detail::plane_difference sweep = {turned(dt_ac, false), turned(dt_ab, true), det};
  const detail::plane_difference side = {turned(ds_ac, true), turned(ds_ab, false), det};
  for_components(sweep, out.sweep, in.corner[a], in.corner[b], in.corner[c]);
  for_components(side, out.side, in.corner[a], in.corner[b], in.corner[c]);
  return out;
}

}  // namespace hls
}  // namespace relievo
