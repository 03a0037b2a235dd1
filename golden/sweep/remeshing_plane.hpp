// remeshing_plane: the coordinate plane in which a triangle is remeshed, and the names of its corners there.
//   s = main direction of the primary edge AB;  t = the other axis with the larger |det|, ties to the earlier axis
//   det = (B - A) x (C - A) in (s, t);  tau = -1 where det < 0:  C lies above AB in t' = tau t
//                                                                          Gumhold & Huettner 1999, sections 3.4.1 and 3.4.3
//   in   p[3]       grid   the corners
//        edge              the primary edge
//        axis              its main direction
//   out  s, t              axes
//        a, b, c           corners: A at the lower s of the primary edge, B its other end, C the side vertex.
//                          Equal s, that is all corners equal: a = edge, b = the next corner
//        det        35 bits, exact
//        mirrored          tau = -1
#pragma once
#include <cstdint>
#include <cstdlib>
#include <glm/glm.hpp>

#include "golden/sweep/remeshed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct remeshing_plane_in {
  glm::dvec3 p[3] = {};
  int edge = 0;
  int axis = 0;
  RELIEVO_FIELDS(p, edge, axis)
};
struct remeshing_plane_out {
  int s = 0, t = 0;
  int a = 0, b = 0, c = 0;
  double det = 0;
  bool mirrored = false;
  RELIEVO_FIELDS(s, t, a, b, c, det, mirrored)
};

inline remeshing_plane_out remeshing_plane(remeshing_plane_in const& in) {
  remeshing_plane_out out;
  out.s = in.axis;
  out.a = in.edge;
  out.b = (in.edge + 1) % 3;
  out.c = (in.edge + 2) % 3;
  if (in.p[out.b][out.s] < in.p[out.a][out.s]) {
    const int low = out.b;
    out.b = out.a;
    out.a = low;
  }
  const grid_vector a(in.p[out.a]), ab = grid_vector(in.p[out.b]) - a, ac = grid_vector(in.p[out.c]) - a;
  const auto determinant = [&](int t) { return ab[out.s] * ac[t] - ab[t] * ac[out.s]; };
  const int earlier = out.s == 0 ? 1 : 0, later = out.s == 2 ? 1 : 2;
  out.t = std::abs(determinant(later)) > std::abs(determinant(earlier)) ? later : earlier;
  const std::int64_t det = determinant(out.t);
  out.det = static_cast<double>(det);
  out.mirrored = det < 0;
  return out;
}

}  // namespace golden
}  // namespace relievo
