// vertex: what a mesh carries per vertex, and the one order by value that all orientation uses.
//                                                                              Doggett & Hirche 2000, sections 2.1 and 3.1.5
//   p            position     P, on the base surface (P_w)
//   n, t         unit         N and tangent T there
//   u            coordinate   U, in texels
//   displaced_p  position     P'
//   displaced_n  unit         N'
//   screen, w    screen, depth   P'_s in pixels and its depth; behind: at or behind the eye, screen is (0, 0)
//   screen_n     unit         N'_s, in view space; away: the normal points away from the eye
//   displaced                 P', N' and P'_s are valid
//   transformed               N'_s and away are valid
//
// barycentric is no field of the hardware's record: the vertex's exact weights in its base triangle times 2^60, which
// tests use to add up areas without any rounding.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "golden/surface/map_regs.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct vertex {
  glm::dvec3 p{0}, n{0}, t{0};
  glm::dvec2 u{0};
  glm::dvec3 displaced_p{0}, displaced_n{0};
  glm::dvec2 screen{0};
  double w = 0;
  bool behind = false;
  glm::dvec3 screen_n{0};
  bool away = false;
  bool displaced = false;
  bool transformed = false;
  RELIEVO_FIELDS(p, n, t, u, displaced_p, displaced_n, screen, w, behind, screen_n, away, displaced, transformed)

  std::array<std::int64_t, 3> barycentric{};
};

// Strict lexicographic order of (P, N, T, v, u); on a wrapped axis the coordinate W is 0.
inline bool precedes(vertex const& a, vertex const& b, map_regs const& map) {
  for (int i = 0; i < 3; ++i)
    if (a.p[i] != b.p[i]) return a.p[i] < b.p[i];
  for (int i = 0; i < 3; ++i)
    if (a.n[i] != b.n[i]) return a.n[i] < b.n[i];
  for (int i = 0; i < 3; ++i)
    if (a.t[i] != b.t[i]) return a.t[i] < b.t[i];
  const auto on_axis = [](double x, double size, bool wrap) { return wrap && x == size ? 0.0 : x; };
  const double av = on_axis(a.u.y, map.height, map.wrap_v), bv = on_axis(b.u.y, map.height, map.wrap_v);
  if (av != bv) return av < bv;
  return on_axis(a.u.x, map.width, map.wrap_u) < on_axis(b.u.x, map.width, map.wrap_u);
}

}  // namespace golden
}  // namespace relievo
