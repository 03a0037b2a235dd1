// vertex_data: what a vertex of the sweep carries beside its name.
//   Gumhold & Huettner 1999, 3.2, Figure 5
//   base_vertex    a corner as it is given: P, N, T, U, colour
//   interpolants   the same times c = 2^e / w, and c: what is linear in the grid; from perspective_preparation
//   vertex_steps   the same with 16 guard bits behind it: differences, and sums of them, exact modulo 2^48
//   for_attributes(op, out, in...)    op(out.p[0], in.p[0]...) and so on, for the 15 components that all three have
//   for_components(op, out, in...)    and for c
#pragma once
#include "hls/core/fixed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace hls {

struct base_vertex {
  fixed<formats::position> p[3];
  fixed<formats::unit> n[3];
  fixed<formats::unit> t[3];
  fixed<formats::coordinate> u[2];
  fixed<formats::colour> colour[4];
  RELIEVO_FIELDS(p, n, t, u, colour)
};
struct interpolants {
  fixed<formats::interp_position> p[3];
  fixed<formats::interp_unit> n[3];
  fixed<formats::interp_unit> t[3];
  fixed<formats::interp_coordinate> u[2];
  fixed<formats::interp_colour> colour[4];
  fixed<formats::interp_c> c;
  RELIEVO_FIELDS(p, n, t, u, colour, c)
};
struct vertex_steps {
  fixed<formats::step_position> p[3];
  fixed<formats::step_unit> n[3];
  fixed<formats::step_unit> t[3];
  fixed<formats::step_coordinate> u[2];
  fixed<formats::step_colour> colour[4];
  fixed<formats::step_c> c;
  RELIEVO_FIELDS(p, n, t, u, colour, c)
};

constexpr int guard_bits = 16;
// An interpolant with the guard bits behind it.
template <class Step, class Interpolant>
constexpr bool is_step_of() {
  return Step::fraction == Interpolant::fraction + guard_bits;
}

template <class Op, class Out, class... In>
inline void for_attributes(Op op, Out& out, In const&... in) {
  for (int i = 0; i < 3; ++i) {
    op(out.p[i], in.p[i]...);
    op(out.n[i], in.n[i]...);
    op(out.t[i], in.t[i]...);
  }
  for (int i = 0; i < 2; ++i) op(out.u[i], in.u[i]...);
  for (int i = 0; i < 4; ++i) op(out.colour[i], in.colour[i]...);
}
template <class Op, class Out, class... In>
inline void for_components(Op op, Out& out, In const&... in) {
  for_attributes(op, out, in...);
  op(out.c, in.c...);
}

}  // namespace hls
}  // namespace relievo
