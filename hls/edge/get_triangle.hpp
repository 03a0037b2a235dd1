// get_triangle: which vertices of a triangle still have to be displaced and transformed, and which normals only transformed.
//   Doggett & Hirche 2000, section 3, Get Triangle: "checks which vertices and normals of incoming triangles have already been
//   transformed into screen space and only sends the new vertices and their normals through the Transform unit"
//   in    t            triangle, from the host or the queue
//   regs  max_generation
//   out   new_surface  per vertex: P', N' and P'_s are to be computed (base vertices)
//         new_normal   per vertex: N'_s is to be computed (base vertices; inserted vertices on their next pass)
//         settled      per edge: not to be tested; an edge at the generation limit is settled when it is met
//   initiation interval 1
#pragma once
#include "hls/edge/triangle.hpp"

namespace relievo {
namespace hls {

struct get_triangle_out {
  bool new_surface[3];
  bool new_normal[3];
  bool settled[3];
  RELIEVO_FIELDS(new_surface, new_normal, settled)
};

inline get_triangle_out get_triangle(triangle const& t, fixed<formats::generation> max_generation) {
  get_triangle_out out;
  for (int i = 0; i < 3; ++i) {
    out.new_surface[i] = !t.v[i].displaced;
    out.new_normal[i] = !t.v[i].transformed;
    out.settled[i] = t.settled[i] || t.generation[i] >= max_generation;
  }
  return out;
}

}  // namespace hls
}  // namespace relievo
