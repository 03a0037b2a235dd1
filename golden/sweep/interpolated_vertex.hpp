// interpolated_vertex: the data of a vertex from its name.                     Gumhold & Huettner 1999, section 3.2; numerics, exactness
//   edge e, i    V = V_0 + i D_edge                                V_0 the canonical end, in the edge's own block
//   grid s, t    V = V_A + (s - A.s) D_sweep + (t - A.t) D_side    one origin for the whole triangle, in the triangle's block
//
//   in   p, plane, corner, end   as difference_vertices
//        difference              its output
//        name                    remeshed_vertex, of an edge or of the grid
//   out  vertex_steps            exact, given the words of the differences
//
// A vertex of the grid lies within the triangle, so V is within the hull of the corners, up to what the steps lost: half an LSB each,
// at most (|s - A.s| + |t - A.t|) / 2 <= 2^14 in all, a quarter of an LSB of the interpolant; on an edge i / 2, an eighth. The sum is below
// 2^43 + 2^14 and fits its 48 bits; the products stay below 2^60.
//
// Error: std::logic_error for a corner, whose data are the given words.
#pragma once
#include <glm/glm.hpp>
#include <stdexcept>

#include "golden/sweep/difference_vertices.hpp"
#include "golden/sweep/remeshed.hpp"
#include "golden/sweep/remeshing_plane.hpp"
#include "golden/sweep/vertex_data.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct interpolated_vertex_in {
  glm::dvec3 p[3] = {};
  remeshing_plane_out plane;
  interpolants corner[3];
  interpolants end[3][2];
  difference_vertices_out difference;
  remeshed_vertex name;
  RELIEVO_FIELDS(p, plane, corner, end, difference, name)
};

template <class Rounding = rounded>
vertex_steps interpolated_vertex(interpolated_vertex_in const& in) {
  using numbers = step_numbers<Rounding>;
  using number = typename numbers::number;
  vertex_steps out;
  if (in.name.kind == kind_edge) {
    const auto i = static_cast<number>(in.name.i);
    each_component(
        [i](auto f, double const& start, double const& edge, double& v) {
          using F = decltype(f);
          v = numbers::template step<F>(numbers::template of_interpolant<F>(start) + i * numbers::template of_step<F>(edge));
        },
        in.end[in.name.number][0], in.difference.edge[in.name.number], out);
  } else if (in.name.kind == kind_grid) {
    glm::dvec3 const& a = in.p[in.plane.a];
    const auto s = static_cast<number>(in.name.s - a[in.plane.s]), t = static_cast<number>(in.name.t - a[in.plane.t]);
    each_component(
        [s, t](auto f, double const& start, double const& sweep, double const& side, double& v) {
          using F = decltype(f);
          v = numbers::template step<F>(numbers::template of_interpolant<F>(start) + s * numbers::template of_step<F>(sweep) +
                                        t * numbers::template of_step<F>(side));
        },
        in.corner[in.plane.a], in.difference.sweep, in.difference.side, out);
  } else {
    throw std::logic_error("interpolated_vertex: a corner has its given words");
  }
  return out;
}

}  // namespace golden
}  // namespace relievo
