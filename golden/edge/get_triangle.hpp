// get_triangle: which vertices of a triangle still need what.                    Doggett & Hirche 2000, section 3 (Get Triangle)
//
//   in    t   triangle
//   regs  max_generation
//   out   new_surface[3]   P', N' and P'_s are to be computed: base triangles only
//         new_normal[3]    N'_s is to be computed: it is left out when a vertex is inserted
//         settled[3]       edges not to be tested: settled before, or at the limit
#pragma once
#include "golden/edge/triangle.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct get_triangle_out {
  bool new_surface[3] = {false, false, false};
  bool new_normal[3] = {false, false, false};
  bool settled[3] = {false, false, false};
  RELIEVO_FIELDS(new_surface, new_normal, settled)
};

template <class Rounding>
get_triangle_out get_triangle(triangle const& t, double max_generation) {
  get_triangle_out out;
  for (int i = 0; i < 3; ++i) {
    out.new_surface[i] = !t.v[i].displaced;
    out.new_normal[i] = !t.v[i].transformed;
    out.settled[i] = t.settled[i] || t.generation[i] >= max_generation;
  }
  return out;
}

}  // namespace golden
}  // namespace relievo
