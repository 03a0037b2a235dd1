// triangle: the record that circulates, and the record that leaves.
//   v           three vertices; edge i runs from vertex i to vertex (i+1) mod 3, counter-clockwise
//   index       base triangle
//   generation  per edge, 0 on the base mesh
//   settled     per edge: it was tested and did not split, or its generation is at the limit; it is never tested again
//   last        on the way in: last base triangle of the mesh
// Out: what rasteriser, lighting and a second pass need of each vertex; empty marks the record that only carries `last` of a mesh
// of which nothing was put out.
#pragma once
#include "hls/surface/vertex.hpp"

namespace relievo {
namespace hls {

struct triangle {
  vertex v[3];
  fixed<formats::index> index;
  fixed<formats::generation> generation[3];
  bool settled[3];
  bool last;
  RELIEVO_FIELDS(v, index, generation, settled, last)
};

struct out_vertex {
  fixed<formats::position> p[3];
  fixed<formats::unit> t[3];
  fixed<formats::coordinate> u[2];
  fixed<formats::position> displaced_p[3];
  fixed<formats::unit> displaced_n[3];
  fixed<formats::screen> screen[2];
  fixed<formats::depth> w;
  bool behind;
  fixed<formats::unit> screen_n[3];
  bool away;
  RELIEVO_FIELDS(p, t, u, displaced_p, displaced_n, screen, w, behind, screen_n, away)
};

struct triangle_out {
  out_vertex v[3];
  fixed<formats::index> index;
  bool empty;
  bool last;
  RELIEVO_FIELDS(v, index, empty, last)
};

namespace detail {
template <class T, int N>
inline void copy(T (&to)[N], T const (&from)[N]) {
  for (int i = 0; i < N; ++i) to[i] = from[i];
}
}  // namespace detail

inline triangle_out to_output(triangle const& t) {
  triangle_out out;
  for (int i = 0; i < 3; ++i) {
    detail::copy(out.v[i].p, t.v[i].p);
    detail::copy(out.v[i].t, t.v[i].t);
    detail::copy(out.v[i].u, t.v[i].u);
    detail::copy(out.v[i].displaced_p, t.v[i].displaced_p);
    detail::copy(out.v[i].displaced_n, t.v[i].displaced_n);
    detail::copy(out.v[i].screen, t.v[i].screen);
    out.v[i].w = t.v[i].w;
    out.v[i].behind = t.v[i].behind;
    detail::copy(out.v[i].screen_n, t.v[i].screen_n);
    out.v[i].away = t.v[i].away;
  }
  out.index = t.index;
  out.empty = false;
  out.last = false;
  return out;
}

}  // namespace hls
}  // namespace relievo
