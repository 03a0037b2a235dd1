// swept_data: triangles with vertex data, from corners in the world to what difference_vertices and the walk take.
//
//   draw_vertex(g)              a base_vertex: any words, and in one of four the ends of the formats
//   draw_depth(g, near, far)    raw w, evenly by its logarithm
//   swept_triangle s(p, v, w)   corners on the grid, their data and depths; s.in is the input of difference_vertices: corner in the block
//                               of the three, end in the block of the two, canonical end first
//   draw_swept(g, p)            the same with drawn data, far / near up to 10,000
//   write_corners(port, in)     the nine words of a triangle's data, as the entry points take them
#pragma once
#include <array>
#include <cmath>

#include "hls/core/packed.hpp"
#include "hls/sweep/difference_vertices.hpp"
#include "hls/sweep/perspective_preparation.hpp"
#include "tests/support/remeshed_mesh.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {

using depth_word = hls::fixed<formats::depth>;

inline hls::base_vertex draw_vertex(generator& g) {
  hls::base_vertex v{};
  draw_vector(v, g.chance(4) ? draw::corner : draw::uniform, g);
  return v;
}
inline depth_word draw_depth(generator& g, std::int64_t near, std::int64_t far) {
  const double place = static_cast<double>(g.between(0, 1 << 20)) / (1 << 20);
  const double w = static_cast<double>(near) * std::pow(static_cast<double>(far) / static_cast<double>(near), place);
  return hls::from_raw<formats::depth>(std::min(static_cast<std::int64_t>(w), far));
}

struct swept_triangle {
  swept_triangle(grid_triangle const& corners, std::array<hls::base_vertex, 3> const& vertices, std::array<depth_word, 3> const& depths)
      : p(corners), vertex(vertices), w(depths), setup(hls::set_up(corners_of(corners))) {
    const hls::sweep_line_in words = corners_of(p);
    in.plane = setup.plane;
    const hls::block_power whole = hls::block_exponent(w[0], w[1], w[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis) in.p[i][axis] = words.p[i][axis];
      in.corner[i] = hls::perspective_preparation({vertex[i], w[i], whole});
      const std::size_t low = canonical(i), high = low == i ? (i + 1) % 3 : i;
      const hls::block_power edge = hls::block_exponent(w[low], w[high]);
      in.end[i][0] = hls::perspective_preparation({vertex[low], w[low], edge});
      in.end[i][1] = hls::perspective_preparation({vertex[high], w[high], edge});
    }
  }
  // The corner at which edge e begins.
  std::size_t canonical(std::size_t e) const {
    const grid_point &from = p[e], &to = p[(e + 1) % 3];
    const std::size_t main = main_axis(from, to);
    return from[main] <= to[main] ? e : (e + 1) % 3;
  }
  std::int64_t steps(std::size_t e) const {
    const std::size_t main = main_axis(p[e], p[(e + 1) % 3]);
    return std::abs(p[e][main] - p[(e + 1) % 3][main]);
  }

  grid_triangle p;
  std::array<hls::base_vertex, 3> vertex;
  std::array<depth_word, 3> w;
  hls::sweep_setup setup;
  hls::difference_vertices_in in{};
};

inline swept_triangle draw_swept(generator& g, grid_triangle const& p) {
  // From w_min, 2^-8, to the far end of the format.
  const std::int64_t near = std::int64_t{1} << g.between(12, 27), far = std::min<std::int64_t>(near * 10000, (std::int64_t{1} << 28) - 1);
  return {
      p, {draw_vertex(g), draw_vertex(g), draw_vertex(g)}, {draw_depth(g, near, far), draw_depth(g, near, far), draw_depth(g, near, far)}};
}

template <class Port>
void write_corners(Port& corners, hls::difference_vertices_in const& in) {
  for (hls::interpolants const& corner : in.corner) corners.write(hls::pack(corner));
  for (auto const& edge : in.end)
    for (hls::interpolants const& end : edge) corners.write(hls::pack(end));
}

}  // namespace relievo::test
