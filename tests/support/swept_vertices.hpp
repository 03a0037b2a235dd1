// swept_vertices: base triangles with random vertex data, and golden's data of the vertices that the sweep makes of them.
//
//   base_triangle                        corners on the grid, their data, their w
//   draw_base_vertex(d)                  a place within 4, unit N and T, a texel of 8192 x 8192, a colour up to 1
//   draw_base_triangle(d, grid, far)     with w from anywhere above 2^-8 to at most `far` times that
//   draw_grid(g), draw_any(d, g)         corners from a few cells to the longest edges, thin and flat ones; with `far` up to 10^4
//   to_grid(p)                           corners of tests/support/grid_triangles.hpp as golden's
//   swept_vertices<Rounding>(triangle)   the sweep's set-up;  at(name) the vertex's data,  corrected(name) back in the world
//     draw_name(d, name)                 a vertex of an edge or within, drawn; false where the triangle has none
//     weights(name, b)                   its barycentric weights: of the corners on the grid, exact up to the division
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "golden/sweep/interpolated_vertex.hpp"
#include "golden/sweep/perspective_correction.hpp"
#include "golden/sweep/perspective_preparation.hpp"
#include "golden/sweep/sweep_line.hpp"
#include "tests/support/draw.hpp"
#include "tests/support/grid_triangles.hpp"
#include "tests/support/settings.hpp"

namespace relievo::test {

struct base_triangle {
  glm::dvec3 p[3] = {};
  golden::base_vertex vertex[3];
  double w[3] = {0, 0, 0};
};

constexpr double largest_coordinate = 8192;

inline golden::base_vertex draw_base_vertex(draw& d) {
  golden::base_vertex v;
  v.p = d.words<formats::position>(-4, 4);
  v.n = d.unit();
  v.t = d.unit();
  for (int i = 0; i < 2; ++i) v.u[i] = d.integer(0, 9) == 0 ? largest_coordinate : d.word<formats::coordinate>(0, largest_coordinate);
  for (int i = 0; i < 4; ++i) v.colour[i] = d.integer(0, 9) == 0 ? 1 : d.word<formats::colour>(0, 1);
  return v;
}

inline void to_grid(grid_triangle const& grid, glm::dvec3 (&p)[3]) {
  for (std::size_t corner = 0; corner < 3; ++corner) p[corner] = {grid[corner][0], grid[corner][1], grid[corner][2]};
}

inline base_triangle draw_base_triangle(draw& d, grid_triangle const& grid, double far) {
  base_triangle triangle;
  to_grid(grid, triangle.p);
  const double near = std::exp2(d.real(-8, 8 - std::log2(far)));
  for (int i = 0; i < 3; ++i) {
    triangle.vertex[i] = draw_base_vertex(d);
    triangle.w[i] = rounded::at<formats::depth>(near * std::exp2(d.real(0, std::log2(far))));
  }
  const int nearest = d.integer(0, 2);
  triangle.w[nearest] = rounded::at<formats::depth>(near);
  if (d.coin()) triangle.w[(nearest + 1) % 3] = rounded::at<formats::depth>(near * far);
  return triangle;
}

inline grid_triangle draw_grid(generator& g) {
  constexpr int sizes[5] = {4, 12, 60, 400, 16383};
  const int size = sizes[g.below(5)];
  grid_triangle p = g.chance(3) ? draw_sliver(g, size) : draw_triangle(g, size);
  if (g.chance(4)) {
    const std::size_t axis = g.below(3);
    p[1][axis] = p[2][axis] = p[0][axis];
  }
  return p;
}
inline base_triangle draw_any(draw& d, generator& g) { return draw_base_triangle(d, draw_grid(g), std::exp2(d.real(0, std::log2(1e4)))); }

// One round for so many random vectors of this run.
inline std::uint64_t rounds(std::uint64_t share) { return vector_count() / share + 1; }

// The word of a value, which must be one.
template <class F>
std::int64_t word(double x) {
  const double scaled = x * golden::power_of_two(F::fraction);
  EXPECT_EQ(scaled, std::nearbyint(scaled)) << "no word";
  EXPECT_TRUE(scaled >= golden::range_of<F>::raw_min && scaled <= golden::range_of<F>::raw_max) << scaled << " is outside its format";
  return static_cast<std::int64_t>(scaled);
}

template <class Rounding>
class swept_vertices {
 public:
  explicit swept_vertices(base_triangle const& triangle) {
    for (int i = 0; i < 3; ++i) in_.p[i] = triangle.p[i];
    in_.plane = golden::setup_of({{in_.p[0], in_.p[1], in_.p[2]}}).plane;
    const auto prepared = golden::prepare_triangle<Rounding>(triangle.p, triangle.vertex, triangle.w);
    golden::difference_vertices_in differences;
    differences.plane = in_.plane;
    for (int i = 0; i < 3; ++i) {
      differences.p[i] = in_.p[i];
      in_.corner[i] = differences.corner[i] = prepared.corner[i];
      for (int k = 0; k < 2; ++k) in_.end[i][k] = differences.end[i][k] = prepared.end[i][k];
    }
    in_.difference = golden::difference_vertices<Rounding>(differences);
  }

  golden::interpolated_vertex_in const& setup() const { return in_; }
  golden::remeshing_plane_out const& plane() const { return in_.plane; }
  double steps_of(int e) const { return golden::main_direction({{in_.p[e], in_.p[(e + 1) % 3]}}).n; }
  // Steps of the primary edge.
  double n() const { return in_.p[plane().b][plane().s] - in_.p[plane().a][plane().s]; }

  golden::vertex_steps at(golden::remeshed_vertex const& name) const {
    golden::interpolated_vertex_in in = in_;
    in.name = name;
    return golden::interpolated_vertex<Rounding>(in);
  }
  golden::perspective_correction_out corrected(golden::remeshed_vertex const& name) const {
    return golden::perspective_correction<Rounding>({at(name)}, {glm::dvec2(largest_coordinate)});
  }

  bool draw_name(draw& d, golden::remeshed_vertex& name) const {
    const int e = d.integer(0, 2);
    if (d.coin()) {
      if (steps_of(e) < 2) return false;
      name = {golden::kind_edge, e, static_cast<double>(d.integer(1, static_cast<int>(steps_of(e)) - 1)), 0, 0};
      return true;
    }
    if (std::abs(plane().det) <= n()) return false;
    for (int attempt = 0; attempt < 10; ++attempt) {
      const double x = std::sqrt(d.real(0, 1)), y = d.real(0, 1);
      const glm::dvec3 place = in_.p[e] * (1 - x) + in_.p[(e + 1) % 3] * (x * (1 - y)) + in_.p[(e + 2) % 3] * (x * y);
      name = {golden::kind_grid, 0, 0, std::round(place[plane().s]), std::round(place[plane().t])};
      long double b[3];
      weights(name, b);
      if (b[0] >= 0 && b[1] >= 0 && b[2] >= 0) return true;
    }
    return false;
  }

  void weights(golden::remeshed_vertex const& name, long double (&b)[3]) const {
    const int a = plane().a;
    if (name.kind == golden::kind_edge) {
      const int e = name.number, next = (e + 1) % 3, axis = golden::main_direction({{in_.p[e], in_.p[next]}}).axis;
      const int canonical = in_.p[e][axis] <= in_.p[next][axis] ? e : next;
      b[(e + 2) % 3] = 0;
      b[e + next - canonical] = static_cast<long double>(name.i) / steps_of(e);
      b[canonical] = 1 - b[e + next - canonical];
      return;
    }
    const glm::dvec3 ab = in_.p[plane().b] - in_.p[a], ac = in_.p[plane().c] - in_.p[a];
    const double s = name.s - in_.p[a][plane().s], t = name.t - in_.p[a][plane().t];
    b[plane().b] = static_cast<long double>(s * ac[plane().t] - t * ac[plane().s]) / plane().det;
    b[plane().c] = static_cast<long double>(t * ab[plane().s] - s * ab[plane().t]) / plane().det;
    b[a] = (plane().det - static_cast<long double>(s * ac[plane().t] - t * ac[plane().s]) -
            static_cast<long double>(t * ab[plane().s] - s * ab[plane().t])) /
           plane().det;
  }

 private:
  golden::interpolated_vertex_in in_;
};

}  // namespace relievo::test
