// difference_vertices: the vertex data of one step along each edge, along the sweep and to the side.
//                                                                              Gumhold & Huettner 1999, section 3.4.2, (9)-(11)
//   D_edge = (V_1 - V_0) / n_e, V_0 at the canonical end
//   D_sweep = (dV_AB dt_AC - dV_AC dt_AB) / det,  D_side = (dV_AC ds_AB - dV_AB ds_AC) / det,  det = ds_AB dt_AC - ds_AC dt_AB
//
//   in   p[3]        grid;  plane   remeshing_plane's output
//        corner[3]   interpolants   of the triangle's block
//        end[3][2]   interpolants   of each edge's own block, edge e from corner e to (e+1)%3; the canonical end first
//   out  edge[3]     vertex_steps   0 where the edge has no step
//        sweep, side vertex_steps   0 where |det| <= n, the steps of the primary edge: then there is no vertex on the grid
//   registers: step_*, correctly rounded (half up, also for a negative quotient), in int64
//
// Every number here fits int64, and every step its 48 bits. AB is the longest edge, so no difference of grid positions is above n;
// a difference of interpolants is below 2^28 of their LSB, 2^44 with the guard bits. So an edge's step is below 2^44; the two
// products of a numerator, at most 2^44 n each, are below 2^59 for n <= 16383 (2^61 for any words of grid), and with |det| >= n + 1
// the quotient is below 2^45.
#pragma once
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "golden/sweep/main_direction.hpp"
#include "golden/sweep/remeshing_plane.hpp"
#include "golden/sweep/vertex_data.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct difference_vertices_in {
  glm::dvec3 p[3] = {};
  remeshing_plane_out plane;
  interpolants corner[3];
  interpolants end[3][2];
  RELIEVO_FIELDS(p, plane, corner, end)
};
struct difference_vertices_out {
  vertex_steps edge[3];
  vertex_steps sweep, side;
  RELIEVO_FIELDS(edge, sweep, side)
};

template <class Rounding = rounded>
difference_vertices_out difference_vertices(difference_vertices_in const& in) {
  using numbers = step_numbers<Rounding>;
  using number = typename numbers::number;
  difference_vertices_out out;

  for (int e = 0; e < 3; ++e) {
    const auto n = static_cast<number>(main_direction({{in.p[e], in.p[(e + 1) % 3]}}).n);
    if (n == 0) continue;
    each_component(
        [n](auto f, double const& from, double const& to, double& step) {
          using F = decltype(f);
          step = numbers::template step<F>(
              numbers::quotient(numbers::template of_interpolant<F>(to) - numbers::template of_interpolant<F>(from), n));
        },
        in.end[e][0], in.end[e][1], out.edge[e]);
  }

  const glm::dvec3 ab = in.p[in.plane.b] - in.p[in.plane.a], ac = in.p[in.plane.c] - in.p[in.plane.a];
  if (std::abs(in.plane.det) <= std::abs(ab[in.plane.s])) return out;
  const auto s_ab = static_cast<number>(ab[in.plane.s]), t_ab = static_cast<number>(ab[in.plane.t]);
  const auto s_ac = static_cast<number>(ac[in.plane.s]), t_ac = static_cast<number>(ac[in.plane.t]);
  const auto det = static_cast<number>(in.plane.det);
  each_component(
      [=](auto f, double const& va, double const& vb, double const& vc, double& sweep, double& side) {
        using F = decltype(f);
        const number a = numbers::template of_interpolant<F>(va);
        const number v_ab = numbers::template of_interpolant<F>(vb) - a, v_ac = numbers::template of_interpolant<F>(vc) - a;
        sweep = numbers::template step<F>(numbers::quotient(v_ab * t_ac - v_ac * t_ab, det));
        side = numbers::template step<F>(numbers::quotient(v_ac * s_ab - v_ab * s_ac, det));
      },
      in.corner[in.plane.a], in.corner[in.plane.b], in.corner[in.plane.c], out.sweep, out.side);
  return out;
}

}  // namespace golden
}  // namespace relievo
