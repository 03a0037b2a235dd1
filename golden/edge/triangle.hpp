// triangle: a triangle under way in the edge engine, and what leaves the engine.   Doggett & Hirche 2000, sections 3 and 3.1.5
//
//   triangle       v[3]            edge i runs from vertex i to vertex (i+1)%3, counter-clockwise
//                  index           base triangle
//                  generation[3]   of each edge: how often it was halved or born
//                  settled[3]      the edge was tested and not split, or reached the limit: it is never tested again
//                  last            last base triangle of the mesh (on the way in only)
//   triangle_out   v[3], index; empty: no triangle, carries `last` alone when nothing at all was put out; last
//
// path and barycentric are no fields of the hardware's records: path is 1 followed by two bits per generation, the place of
// each ancestor in tessellate's output; barycentric see vertex.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "golden/surface/vertex.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct triangle {
  vertex v[3];
  double index = 0;
  glm::dvec3 generation{0};
  bool settled[3] = {false, false, false};
  bool last = false;
  RELIEVO_FIELDS(v, index, generation, settled, last)

  std::uint64_t path = 1;
};

struct out_vertex {
  glm::dvec3 p{0}, t{0};
  glm::dvec2 u{0};
  glm::dvec3 displaced_p{0}, displaced_n{0};
  glm::dvec2 screen{0};
  double w = 0;
  bool behind = false;
  glm::dvec3 screen_n{0};
  bool away = false;
  RELIEVO_FIELDS(p, t, u, displaced_p, displaced_n, screen, w, behind, screen_n, away)

  std::array<std::int64_t, 3> barycentric{};
};

struct triangle_out {
  out_vertex v[3];
  double index = 0;
  bool empty = false;
  bool last = false;
  RELIEVO_FIELDS(v, index, empty, last)

  std::uint64_t path = 1;
};

inline out_vertex leaving(vertex const& v) {
  return {v.p, v.t, v.u, v.displaced_p, v.displaced_n, v.screen, v.w, v.behind, v.screen_n, v.away, v.barycentric};
}

}  // namespace golden
}  // namespace relievo
