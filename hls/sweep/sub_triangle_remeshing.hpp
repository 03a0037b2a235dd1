// sub_triangle_remeshing: the strips of one sub-triangle, one after the other; the outer loop.
//   Gumhold & Huettner 1999, 3.4.4, Figures 14 and 15
//   From column k0 to k1, in s': P_k = P_(k-1) + D_primary on the primary edge; the grid point nearest to it by D_sweep, and D_side as
//   the row of P_k goes 0 or 1 up or down; between columns k and k + 1 a side_walk.
//   in    p     grid[3][3];  plane  from remeshing_plane;  sub  a valid one from case_selection
//         data  walk_data of the triangle; none for a walk of names alone, which sub_triangle_remeshing is
//   out   primitives in order, and the data of their vertices: step() gives the next and says whether it is the last
//   A sub-triangle that does not start in a corner goes on where the one before it ended, on the line s = C.s: the primary edge's
//   registers are not started again, so both sides of the line have the same F, its row and its grid point.
//   Only additions and comparisons: 2 delta is delta + delta.
//   exact; initiation interval 1, a strip is set up in the last clock of the one before; clocks: sweep_line
#pragma once
#include "hls/sweep/case_selection.hpp"
#include "hls/sweep/main_direction.hpp"
#include "hls/sweep/side_walk.hpp"

namespace relievo {
namespace hls {

struct sub_triangle_remeshing_in {
  fixed<formats::grid> p[3][3];
  remeshing_plane_out plane;
  sub_triangle sub;
  RELIEVO_FIELDS(p, plane, sub)
};

template <class Data>
class sub_triangle_remeshing_of {
 public:
  void start(sub_triangle_remeshing_in const& in, walk_data<Data> const& data = walk_data<Data>()) {
    RELIEVO_ADDITIONS_ONLY("setting up the walk");
    using detail::of;
    const bool backward = in.sub.backward;
    const int a = of(in.plane.a), b = of(in.plane.b), start = backward ? b : a, end = backward ? a : b;
    walk_frame<Data>& frame = walk_.frame;
    frame.backward = backward;
    frame.mirrored = in.plane.mirrored;
    frame.flip = backward != (detail::after(a) != b);
    frame.pointed = in.sub.pointed;
    frame.ends_on_edge = in.sub.ends_on_edge;
    frame.k1 = of(in.sub.k1);
    const int from = of(in.sub.from);
    frame.edge[1] = walked(in, data, from, of(in.sub.to));
    frame.edge[0] = in.sub.corner_list ? walked(in, data, start, from) : frame.edge[1];
    // The signs are applied once, so that the walk adds.
    frame.side = frame.mirrored ? wrapped_difference(Data(), data.side) : data.side;
    sweep_ = backward ? wrapped_difference(Data(), data.sweep) : data.sweep;
    k_ = of(in.sub.k0);

    if (in.sub.starts_at_corner) {
      primary_edge_ = walked(in, data, start, end);
      primary_ = detail::edge_begin(primary_edge_, true, column(in, start), row(in, start));
      walk_.registers.put(role_start, detail::corner_of(start), primary_edge_.begin);
      walk_.registers.put(role_base,
                          {detail::two(grid_vertex), detail::two(0), {}, in.p[start][of(in.plane.s)], in.p[start][of(in.plane.t)]},
                          data.base[backward ? 1 : 0]);
    }
    const int first = in.sub.starts_at_corner ? start : from;
    walk_.begin_edge(detail::edge_begin(frame.edge[in.sub.corner_list ? 0 : 1], !in.sub.corner_list, column(in, first), row(in, first)),
                     in.sub.starts_at_corner);
    if (in.sub.ends_on_edge) {
      const int corner = of(in.sub.end_corner);
      frame.upright = walked(in, data, corner, of(in.sub.to));
      walk_.begin_upright(detail::edge_begin(frame.upright, true, column(in, corner), row(in, corner)));
    }
    next_strip(in.sub.starts_at_corner);
  }

  // One clock, one primitive. Returns whether it was the last.
  bool step(primitive& out, Data (&data)[4]) {
    RELIEVO_ADDITIONS_ONLY("the outer loop");
    if (!walk_.step(out, data)) return false;
    ++k_;
    if (k_ == walk_.frame.k1) return true;
    next_strip(false);
    return false;
  }
  bool step(primitive& out) {
    Data data[4];
    return step(out, data);
  }

  side_walk_of<Data> const& walk() const { return walk_; }
  int column() const { return k_; }

 private:
  static std::int32_t column(sub_triangle_remeshing_in const& in, int corner) {
    const std::int32_t s = detail::of(in.p[corner][detail::of(in.plane.s)]);
    return in.sub.backward ? -s : s;
  }
  static std::int32_t row(sub_triangle_remeshing_in const& in, int corner) {
    const std::int32_t t = detail::of(in.p[corner][detail::of(in.plane.t)]);
    return in.plane.mirrored ? -t : t;
  }
  static walked_edge<Data> walked(sub_triangle_remeshing_in const& in, walk_data<Data> const& data, int from, int to) {
    const main_direction_out main = detail::main_direction_of(in.p, from, to);
    const int axis = detail::of(main.axis), number = detail::edge_of(from, to);
    const std::int32_t steps = static_cast<std::int32_t>(raw(main.n)), n = steps == 0 ? 1 : steps;
    const std::int32_t columns = column(in, to) - column(in, from), rows = row(in, to) - row(in, from);
    const bool rising = in.p[from][axis] <= in.p[to][axis];
    const Data step = rising ? data.step[number] : wrapped_difference(Data(), data.step[number]);
    return {n, n + n, columns + columns, rows + rows, from, to, number, rising, data.end[number][rising ? 0 : 1], step};
  }

  void next_strip(bool left_on) {
    walk_registers<Data>& registers = walk_.registers;
    registers.assign(role_left, role_start);
    registers.assign(role_left_grid, role_base);
    const std::int32_t left_row = primary_.row;
    primary_ = detail::edge_step(primary_edge_, primary_);
    const Data start = wrapped_sum(registers.at(role_start).data, primary_edge_.step);
    registers.put(role_start, detail::vertex_of(primary_edge_, primary_.left), start);

    const std::int32_t rows = primary_.row - left_row;  // -1, 0 or 1
    remeshed_vertex base = registers[role_base];
    base.s = moved(base.s, walk_.frame.backward ? -1 : 1);
    base.t = moved(base.t, walk_.frame.mirrored ? -rows : rows);
    Data base_data = wrapped_sum(registers.at(role_base).data, sweep_);
    if (rows > 0) base_data = wrapped_sum(base_data, walk_.frame.side);
    if (rows < 0) base_data = wrapped_difference(base_data, walk_.frame.side);
    registers.put(role_base, base, base_data);
    walk_.count_additions(rows == 0 ? 2 : 3);

    registers.assign(role_right, role_start);
    registers.assign(role_right_grid, role_base);
    walk_.begin_strip(k_, left_row, primary_.row, left_on);
  }
  static fixed<formats::grid> moved(fixed<formats::grid> x, std::int32_t by) {
    return wrap_to<formats::grid>(x + from_raw<format<2, 2, true>>(by));
  }

  side_walk_of<Data> walk_;
  walked_edge<Data> primary_edge_;
  edge_place primary_;
  Data sweep_;  // D_sweep in the direction of s'
  std::int32_t k_ = 0;
};

using sub_triangle_remeshing = sub_triangle_remeshing_of<no_data>;

}  // namespace hls
}  // namespace relievo
