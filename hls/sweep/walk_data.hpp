// walk_data: what a walk carries beside the names of its vertices, and what it adds to it.
//   vertex_steps   the data of a vertex; sums and differences are modulo 2^48
//   no_data        nothing: a walk of names alone
//   walk_data      per triangle, a multiplication for each start; the walk itself only adds
//     end[e][0]    V_0 2^16 at the canonical end of edge e;  end[e][1] = end[e][0] + n D_edge at the other, which a walk from there needs
//     step[e]      D_edge, from the canonical end;  sweep, side  D_sweep, D_side
//     base[0]      A 2^16, of the triangle's block;  base[1] = base[0] + (B.s - A.s) D_sweep + (B.t - A.t) D_side
//   so that, whatever the way, an edge's vertex i is end[e][0] + i D_edge and a grid vertex base[0] + (s - A.s) D_sweep + (t - A.t) D_side
//   exact; initiation interval 1
#pragma once
#include "hls/sweep/difference_vertices.hpp"

namespace relievo {
namespace hls {

struct no_data {};

inline no_data wrapped_sum(no_data, no_data) { return no_data(); }
inline no_data wrapped_difference(no_data, no_data) { return no_data(); }

template <class Data>
struct walk_data {
  Data end[3][2];
  Data step[3];
  Data sweep, side;
  Data base[2];
};

namespace detail {

struct wrapped_plus {
  template <class F>
  void operator()(fixed<F>& out, fixed<F> const& a, fixed<F> const& b) const {
    out = wrap_to<F>(a + b);
  }
};
struct wrapped_minus {
  template <class F>
  void operator()(fixed<F>& out, fixed<F> const& a, fixed<F> const& b) const {
    out = wrap_to<F>(a - b);
  }
};
// a + count D. The product modulo 2^64 is right modulo 2^48.
struct wrapped_multiple {
  std::int64_t count;
  template <class F>
  void operator()(fixed<F>& out, fixed<F> const& a, fixed<F> const& step) const {
    const std::uint64_t product = static_cast<std::uint64_t>(raw(step)) * static_cast<std::uint64_t>(count);
    const std::uint64_t sum = static_cast<std::uint64_t>(raw(a)) + product;
    out = wrap_to<F>(from_raw<format<64, 64 - F::fraction, true>>(static_cast<std::int64_t>(sum)));
  }
};
struct guarded {
  template <class To, class From>
  void operator()(fixed<To>& out, fixed<From> const& in) const {
    static_assert(is_step_of<To, From>(), "the guard bits");
    out = exact_to<To>(in);
  }
};

inline vertex_steps with_guard_bits(interpolants const& in) {
  vertex_steps out;
  for_components(guarded(), out, in);
  return out;
}
inline vertex_steps moved_by(vertex_steps const& from, std::int64_t count, vertex_steps const& step) {
  vertex_steps out;
  for_components(wrapped_multiple{count}, out, from, step);
  return out;
}

}  // namespace detail

inline vertex_steps wrapped_sum(vertex_steps const& a, vertex_steps const& b) {
  vertex_steps sum;
  for_components(detail::wrapped_plus(), sum, a, b);
  return sum;
}
inline vertex_steps wrapped_difference(vertex_steps const& a, vertex_steps const& b) {
  vertex_steps difference;
  for_components(detail::wrapped_minus(), difference, a, b);
  return difference;
}

inline walk_data<vertex_steps> walk_data_of(difference_vertices_in const& in, difference_vertices_out const& differences) {
  walk_data<vertex_steps> out;
  for (int e = 0; e < 3; ++e) {
    out.step[e] = differences.edge[e];
    out.end[e][0] = detail::with_guard_bits(in.end[e][0]);
    out.end[e][1] = detail::moved_by(out.end[e][0], raw(detail::main_direction_of(in.p, e, detail::after(e)).n), out.step[e]);
  }
  const int a = detail::of(in.plane.a), b = detail::of(in.plane.b), s = detail::of(in.plane.s), t = detail::of(in.plane.t);
  out.sweep = differences.sweep;
  out.side = differences.side;
  out.base[0] = detail::with_guard_bits(in.corner[a]);
  out.base[1] =
      detail::moved_by(detail::moved_by(out.base[0], raw(in.p[b][s] - in.p[a][s]), out.sweep), raw(in.p[b][t] - in.p[a][t]), out.side);
  return out;
}

}  // namespace hls
}  // namespace relievo
