// vertex: what a record carries per vertex, and the one order by value.
//   p            P (P_w), undisplaced, position      n, t  N, T, unit           u  U, coordinate[2], in texels
//   displaced_p  P', position                        displaced_n  N', unit
//   screen, w    P'_s, screen[2] and depth           behind  P' at or behind the eye plane
//   screen_n     N'_s, unit                          away    N' points away from the eye
//   displaced    P', N', P'_s are valid              transformed  N'_s and away are valid
//
// precedes(a, b): lexicographic order of the raw words P, N, T, then v and u modulo the wrap. Every tie and every operation on an
// edge that is not symmetric by itself uses it, so that both triangles at an edge do the same.
#pragma once
#include "hls/surface/map_regs.hpp"

namespace relievo {
namespace hls {

struct vertex {
  fixed<formats::position> p[3];
  fixed<formats::unit> n[3];
  fixed<formats::unit> t[3];
  fixed<formats::coordinate> u[2];
  fixed<formats::position> displaced_p[3];
  fixed<formats::unit> displaced_n[3];
  fixed<formats::screen> screen[2];
  fixed<formats::depth> w;
  bool behind;
  fixed<formats::unit> screen_n[3];
  bool away;
  bool displaced;
  bool transformed;
  RELIEVO_FIELDS(p, n, t, u, displaced_p, displaced_n, screen, w, behind, screen_n, away, displaced, transformed)
};

namespace detail {
// -1, 0 or 1
template <class F>
inline int order3(fixed<F> const (&a)[3], fixed<F> const (&b)[3]) {
  for (int i = 0; i < 3; ++i)
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  return 0;
}
inline fixed<formats::coordinate> modulo_wrap(fixed<formats::coordinate> u, fixed<formats::map_size> size, bool wrap) {
  return wrap && u == size ? from_raw<formats::coordinate>(0) : u;
}
}  // namespace detail

inline bool precedes(vertex const& a, vertex const& b, map_regs const& map) {
  const int p = detail::order3(a.p, b.p);
  if (p != 0) return p < 0;
  const int n = detail::order3(a.n, b.n);
  if (n != 0) return n < 0;
  const int t = detail::order3(a.t, b.t);
  if (t != 0) return t < 0;
  const auto av = detail::modulo_wrap(a.u[1], map.height, map.wrap_v);
  const auto bv = detail::modulo_wrap(b.u[1], map.height, map.wrap_v);
  if (av != bv) return av < bv;
  return detail::modulo_wrap(a.u[0], map.width, map.wrap_u) < detail::modulo_wrap(b.u[0], map.width, map.wrap_u);
}

}  // namespace hls
}  // namespace relievo
