// tessellate: builds the two, three or four triangles of a triangle with one, two or three split edges.
//   Doggett & Hirche 2000, 2.6, Figure 6
//   in    t      triangle
//         split  per edge
//         m      vertex[3], the new vertex of edge i where split[i]
//   regs  map (for the order by value), max_generation
//   out   t      triangle[4];  count 2..4
//   order, with a = v[i], b = v[i+1], c = v[i+2]:
//     1  edge i split at m:                    (a, m, c) (m, b, c)
//     2  edge i not split, p on b-c, q on c-a: (q, p, c), then the quad a b p q along its shorter diagonal by P_w, exact:
//        a-p: (a, b, p) (a, p, q); b-q: (a, b, q) (b, p, q); equally long: a-p when a precedes b
//     3  (v0, m0, m2) (m0, v1, m1) (m2, m1, v2) (m0, m1, m2)
//   A half edge has its edge's generation + 1, an inner edge the largest of the split edges' + 1; both are settled at the limit.
//   An edge that did not split is settled.
//   initiation interval: one triangle a clock
#pragma once
#include "hls/edge/triangle.hpp"

namespace relievo {
namespace hls {

struct tessellate_in {
  triangle t;
  bool split[3];
  vertex m[3];
  RELIEVO_FIELDS(t, split, m)
};
struct tessellate_out {
  triangle t[4];
  fixed<format<3, 3, false>> count;
  RELIEVO_FIELDS(t, count)
};

namespace detail {

struct edge_state {
  fixed<formats::generation> generation;
  bool settled;
};

inline edge_state child_edge(fixed<formats::generation> parent, fixed<formats::generation> max_generation) {
  const auto generation = wrap_to<formats::generation>(parent + from_raw<formats::generation>(1));
  return {generation, generation >= max_generation};
}

inline void set_triangle(triangle& t, fixed<formats::index> index, vertex const& a, vertex const& b, vertex const& c, edge_state ab,
                         edge_state bc, edge_state ca) {
  t.v[0] = a;
  t.v[1] = b;
  t.v[2] = c;
  t.index = index;
  t.generation[0] = ab.generation;
  t.generation[1] = bc.generation;
  t.generation[2] = ca.generation;
  t.settled[0] = ab.settled;
  t.settled[1] = bc.settled;
  t.settled[2] = ca.settled;
  t.last = false;
}

// |a - b|^2, exact: 52 bits.
inline auto squared_distance(vertex const& a, vertex const& b) {
  const auto x = a.p[0] - b.p[0];
  const auto y = a.p[1] - b.p[1];
  const auto z = a.p[2] - b.p[2];
  return x * x + y * y + z * z;
}

}  // namespace detail

inline void tessellate(tessellate_in const& in, map_regs const& map, fixed<formats::generation> max_generation, tessellate_out& out) {
  using detail::edge_state;
  using detail::set_triangle;
  int count = 0, split_edge = 0, whole_edge = 0;
  auto highest = from_raw<formats::generation>(0);
  edge_state half[3], whole[3];
  for (int i = 0; i < 3; ++i) {
    half[i] = detail::child_edge(in.t.generation[i], max_generation);
    whole[i] = {in.t.generation[i], true};
    if (in.split[i]) {
      ++count;
      split_edge = i;
      if (in.t.generation[i] > highest) highest = in.t.generation[i];
    } else {
      whole_edge = i;
    }
  }
  const edge_state inner = detail::child_edge(highest, max_generation);
  out.count = from_raw<format<3, 3, false>>(count + 1);

  if (count == 3) {
    vertex const(&v)[3] = in.t.v;
    vertex const(&m)[3] = in.m;
    set_triangle(out.t[0], in.t.index, v[0], m[0], m[2], half[0], inner, half[2]);
    set_triangle(out.t[1], in.t.index, m[0], v[1], m[1], half[0], half[1], inner);
    set_triangle(out.t[2], in.t.index, m[2], m[1], v[2], inner, half[1], half[2]);
    set_triangle(out.t[3], in.t.index, m[0], m[1], m[2], inner, inner, inner);
    return;
  }
  const int i = count == 1 ? split_edge : whole_edge;
  const int bc = (i + 1) % 3, ca = (i + 2) % 3;
  vertex const &a = in.t.v[i], &b = in.t.v[bc], &c = in.t.v[ca];
  if (count == 1) {
    set_triangle(out.t[0], in.t.index, a, in.m[i], c, half[i], inner, whole[ca]);
    set_triangle(out.t[1], in.t.index, in.m[i], b, c, half[i], whole[bc], inner);
    return;
  }
  vertex const &p = in.m[bc], &q = in.m[ca];
  set_triangle(out.t[0], in.t.index, q, p, c, inner, half[bc], half[ca]);
  const auto ap = detail::squared_distance(a, p);
  const auto bq = detail::squared_distance(b, q);
  if (ap < bq || (ap == bq && precedes(a, b, map))) {
    set_triangle(out.t[1], in.t.index, a, b, p, whole[i], half[bc], inner);
    set_triangle(out.t[2], in.t.index, a, p, q, inner, inner, half[ca]);
  } else {
    set_triangle(out.t[1], in.t.index, a, b, q, whole[i], inner, half[ca]);
    set_triangle(out.t[2], in.t.index, b, p, q, half[bc], inner, inner);
  }
}

}  // namespace hls
}  // namespace relievo
