// tessellate: a triangle with 1, 2 or 3 split edges to 2, 3 or 4 triangles.     Doggett & Hirche 2000, section 2.6, figure 6
//
//   in    t   triangle;  split[3];  m[3]   vertex   the new vertex of edge i, valid where split[i]
//   regs  map_regs; max_generation
//   out   t[4]   triangle;  count   2..4
//
//   1 split    (edge a-b)            (a, m, c), (m, b, c)
//   2 splits   (a-b does not split)  p on b-c, q on c-a: (q, p, c), then the quad a b p q along the shorter of a-p and b-q,
//              squared length in P, exact:  a-p: (a, b, p), (a, p, q);  b-q: (a, b, q), (b, p, q).
//              Equal: a-p when a precedes b by value, else b-q
//   3 splits   (v0, m0, m2), (m0, v1, m1), (m2, m1, v2), (m0, m1, m2)
//
// Edges: half of a split edge: generation + 1; not split: as it was, settled; new in the interior: 1 + the largest
// generation of the split edges. New edges are settled when they reach max_generation.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "golden/edge/triangle.hpp"
#include "golden/surface/map_regs.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct tessellate_in {
  triangle t;
  bool split[3] = {false, false, false};
  vertex m[3];
  RELIEVO_FIELDS(t, split, m)
};
struct tessellate_out {
  triangle t[4];
  int count = 0;
  RELIEVO_FIELDS(t, count)
};

namespace detail {

struct edge_record {
  double generation;
  bool settled;
};

inline double squared_length(glm::dvec3 const& a, glm::dvec3 const& b) { return glm::dot(a - b, a - b); }

}  // namespace detail

template <class Rounding>
tessellate_out tessellate(tessellate_in const& in, map_regs const& map, double max_generation) {
  constexpr bits difference = bits_of<formats::position>() + bits_of<formats::position>();
  static_assert(fits_double(dot3(difference, difference)), "squared length");
  using detail::edge_record;
  triangle const& t = in.t;

  double oldest = 0;
  int splits = 0;
  for (int i = 0; i < 3; ++i)
    if (in.split[i]) {
      oldest = glm::max(oldest, t.generation[i]);
      ++splits;
    }
  const edge_record interior{oldest + 1, oldest + 1 >= max_generation};
  // What became of the outer edge i: each half of it, or the whole.
  const auto outer = [&](int i) {
    if (!in.split[i]) return edge_record{t.generation[i], true};
    return edge_record{t.generation[i] + 1, t.generation[i] + 1 >= max_generation};
  };

  tessellate_out out;
  const auto put = [&](std::array<vertex, 3> const& v, std::array<edge_record, 3> const& edges) {
    triangle& child = out.t[out.count];
    for (int i = 0; i < 3; ++i) {
      child.v[i] = v[static_cast<std::size_t>(i)];
      child.generation[i] = edges[static_cast<std::size_t>(i)].generation;
      child.settled[i] = edges[static_cast<std::size_t>(i)].settled;
    }
    child.index = t.index;
    child.last = false;
    child.path = t.path << 2 | static_cast<std::uint64_t>(out.count);
    ++out.count;
  };

  if (splits == 1) {
    const int i = in.split[0] ? 0 : in.split[1] ? 1 : 2;
    const int ib = (i + 1) % 3, ic = (i + 2) % 3;
    put({t.v[i], in.m[i], t.v[ic]}, {outer(i), interior, outer(ic)});
    put({in.m[i], t.v[ib], t.v[ic]}, {outer(i), outer(ib), interior});
  } else if (splits == 2) {
    const int j = !in.split[0] ? 0 : !in.split[1] ? 1 : 2;
    const int jb = (j + 1) % 3, jc = (j + 2) % 3;
    vertex const &a = t.v[j], &b = t.v[jb], &c = t.v[jc], &p = in.m[jb], &q = in.m[jc];
    put({q, p, c}, {interior, outer(jb), outer(jc)});
    const double ap = detail::squared_length(a.p, p.p), bq = detail::squared_length(b.p, q.p);
    const bool ap_shorter = Rounding::exceeds(bq, ap, ap + bq), bq_shorter = Rounding::exceeds(ap, bq, ap + bq);
    if (ap_shorter || (!bq_shorter && precedes(a, b, map))) {
      put({a, b, p}, {outer(j), outer(jb), interior});
      put({a, p, q}, {interior, interior, outer(jc)});
    } else {
      put({a, b, q}, {outer(j), interior, outer(jc)});
      put({b, p, q}, {outer(jb), interior, interior});
    }
  } else if (splits == 3) {
    put({t.v[0], in.m[0], in.m[2]}, {outer(0), interior, outer(2)});
    put({in.m[0], t.v[1], in.m[1]}, {outer(0), outer(1), interior});
    put({in.m[2], in.m[1], t.v[2]}, {interior, outer(1), outer(2)});
    put({in.m[0], in.m[1], in.m[2]}, {interior, interior, interior});
  }
  return out;
}

}  // namespace golden
}  // namespace relievo
