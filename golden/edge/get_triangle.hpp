// get_triangle: which vertices of a triangle still need what.                    Doggett & Hirche 2000, section 3 (Get Triangle)
//
//   in   t   triangle
//   out  new_surface[3]   P', N' and P'_s are to be computed: base triangles only
//        new_normal[3]    N'_s is to be computed: it is left out when a vertex is inserted
#pragma once
#include "golden/edge/triangle.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct get_triangle_in {
  triangle t;
  RELIEVO_FIELDS(t)
};
struct get_triangle_out {
  bool new_surface[3] = {false, false, false};
  bool new_normal[3] = {false, false, false};
  RELIEVO_FIELDS(new_surface, new_normal)
};

template <class Rounding>
get_triangle_out get_triangle(get_triangle_in const& in) {
  get_triangle_out out;
  for (int i = 0; i < 3; ++i) {
    out.new_surface[i] = !in.t.v[i].displaced;
    out.new_normal[i] = !in.t.v[i].transformed;
  }
  return out;
}

}  // namespace golden
}  // namespace relievo
