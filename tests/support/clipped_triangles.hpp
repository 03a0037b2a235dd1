// clipped_triangles: triangles where near_clip's planes are, for its tests.
//   clipped_view s(g)   a camera with near, far and, mostly, the guard band; s.corner(g) a base vertex around a place on a plane
//   vertices_of(out)    the polygon
#pragma once
#include <algorithm>
#include <vector>

#include "hls/sweep/near_clip.hpp"
#include "tests/support/world_words.hpp"

namespace relievo::test {

using polygon = std::vector<hls::base_vertex>;

inline polygon vertices_of(hls::near_clip_out const& out) {
  return polygon(std::begin(out.vertex), std::begin(out.vertex) + raw(out.count));
}

// A camera that looks at the cube, and triangles of any size around a place that it may see.
struct clipped_view {
  view_camera camera;
  hls::near_clip_regs regs{};
  place at;
  long double size;

  explicit clipped_view(generator& g)
      : camera(draw_camera(g)), at(draw_place(g, 7)), size(std::ldexp(1.0L, -static_cast<int>(g.below(20)))) {
    regs.transform = camera.regs;
    regs.near = camera.near;
    regs.far = camera.far;
    regs.guard = !g.chance(4);
    // Where a plane is: near, far, or a side of the guard band, before the near plane.
    const auto pixels = [&g](std::int64_t most) { return static_cast<long double>(g.between(-most, most)); };
    const bool at_a_side = g.chance(2);
    const long double w = at_a_side     ? std::ldexp(value(regs.near), 1 + static_cast<int>(g.below(6)))
                          : g.chance(2) ? value(regs.near)
                                        : value(regs.far);
    long double x = pixels(8190), y = pixels(8190);
    if (at_a_side) (g.chance(2) ? x : y) = g.chance(2) ? 8190 : -8190;
    const place there = camera.at(x * w, y * w, w);
    if (product(there, there) < 49) at = there;
    if (!g.chance(3)) size = std::min(2.0L, std::ldexp(w, 2 - static_cast<int>(g.below(5))));
  }
  hls::base_vertex corner(generator& g) const { return draw_corner(g, at, size); }
};

}  // namespace relievo::test
