// side_walk: one strip of the remeshing, between columns k and k + 1 of the grid; the inner loop, a primitive a clock.
//   Gumhold & Huettner 1999, 3.4.4, Figures 14 and 15. As printed its rules give a valid mesh for few triangles; these are ours:
//   - A grid vertex stands one row above the one below it. On a side it is dragged to the next vertex of the side edge, E, when E has
//     that column and at most the next row, or anyway once the side stands on the edge: then the edge is all there is to walk.
//   - The left takes an edge vertex and moves E on; the right looks at what the left leaves and takes it without moving E on.
//   - Both sides can go on: only the left when E is not above its row, else the lower one, else both: a quad (L, R, TR, TL) with the
//     diagonal R-TL.
//   - E and the next edge vertex En on one grid point (three main directions, small areas): the double step (L, R, E), the row stays.
//   - In the strip that points to a corner R stands there; from E on the last edge on: the end fan (L, En, E), L stays.
//   - On a vertical side edge at the end R walks that edge's vertices instead of the grid. It is a row from one to the next: with such an
//     edge det is n times its height, so the plane of the larger area has its main direction as t.
//   Row: that of the grid point from which a vertex was dragged. The vertices stand in registers that are addressed by index
//   (walk_registers), the side edge is a DDA (walked_edge).
//   Data: side_walk carries names alone, side_walk_of<vertex_steps> the data of each vertex too. What is put out for a corner is 0 there:
//   its data are the given ones.
//
//   Only additions and comparisons. A step writes at most three registers: top_left, top_right and the edge vertex after the next.
//   initiation interval 1; every step but none else puts out a primitive, so a strip takes as many clocks as it has primitives
#pragma once
#include "hls/core/additions_only.hpp"
#include "hls/sweep/walk_data.hpp"
#include "hls/sweep/walk_registers.hpp"
#include "hls/sweep/walked_edge.hpp"

namespace relievo {
namespace hls {

// What holds for a sub-triangle as long as it is walked.
template <class Data>
struct walk_frame {
  bool backward;              // s' = -s
  bool mirrored;              // t' = -t
  bool flip;                  // the frame turns against the base triangle
  bool pointed;               // the last strip points to a corner
  bool ends_on_edge;          // the last strip ends on a vertical edge
  std::int32_t k1;            // last column
  walked_edge<Data> edge[2];  // the list: edge[0] where it has two; edge[1] is the last
  walked_edge<Data> upright;  // the vertical edge at the end
  Data side;                  // D_side in the direction of t'
};

template <class Data>
class side_walk_of {
 public:
  // ---- for the outer loop
  walk_frame<Data> frame;
  walk_registers<Data> registers;
  edge_place edge, next_edge, upright;

  // E is the first vertex of the list, or the one after it where the walk starts in the first.
  void begin_edge(edge_place const& first, bool starts_there) {
    edge = first;
    registers.put(role_edge, detail::vertex_of(on(edge), edge.left), on(edge).begin);
    look_ahead();
    if (starts_there) advance_edge();
  }
  void begin_upright(edge_place const& corner) {
    upright = corner;
    registers.put(role_upright, detail::vertex_of(frame.upright, upright.left), frame.upright.begin);
    advance_upright();
  }
  // The strip from column k, whose first vertices are P_k and P_(k+1) = start, their grid points base_left and base.
  void begin_strip(std::int32_t k, std::int32_t left_row, std::int32_t right_row, bool left_on) {
    k_ = k;
    left_row_ = left_row;
    right_row_ = right_row;
    const bool last = k + 1 == frame.k1;
    left_on_ = left_on;
    pointed_ = frame.pointed && last;
    upright_ = frame.ends_on_edge && last;
    right_on_ = pointed_;
  }

  // One clock, one primitive and the data of its vertices. Returns whether it was the strip's last.
  bool step(primitive& out, Data (&data)[4]) {
    RELIEVO_ADDITIONS_ONLY("the inner loop");
    registers.invalidate(role_top_left);
    registers.invalidate(role_top_right);
    additions_ = 0;
    const bool edge_here = column(edge) == k_ && (left_on_ || edge.row <= left_row_ + 1);
    if (pointed_ && edge_here && edge.last) {
      triangle(out, data, role_left, role_next_edge, role_edge);
      advance_edge();
      return edge.left == 0;
    }
    if (edge_here && column(next_edge) == k_ && next_edge.row == edge.row) {
      triangle(out, data, role_left, role_right, role_edge);
      registers.assign(role_left, role_edge);
      left_on_ = true;
      advance_edge();
      return done();
    }

    edge_place const& seen = edge_here ? next_edge : edge;
    bool edge_there = upright_ || (column(seen) == k_ + 1 && seen.row <= right_row_ + 1);
    bool left = edge_here || !left_on_, right = !right_on_;
    if (left && right) {
      if ((edge_here && edge.row <= left_row_) || left_row_ < right_row_)
        right = false;
      else if (left_row_ > right_row_)
        left = false;
    }
    // The left does not take E after all, which stands in its column: nothing there for the right.
    if (!left && edge_here) edge_there = upright_;

    if (left) set_top_left(edge_here);
    if (right) set_top_right(edge_there);
    if (left && right)
      quad(out, data);
    else
      triangle(out, data, role_left, role_right, left ? role_top_left : role_top_right);
    if (left) move_left(edge_here);
    if (right) move_right(edge_there);
    return done();
  }

  // Vector additions of this clock; the outer loop adds those of a strip's start.
  int additions() const { return additions_; }
  void count_additions(int more) { additions_ += more; }

 private:
  walked_edge<Data> const& on(edge_place const& place) const { return frame.edge[place.last ? 1 : 0]; }
  // All but the end stay before the last column.
  std::int32_t column(edge_place const& place) const {
    return place.column == frame.k1 && !(place.last && place.left == 0) ? frame.k1 - 1 : place.column;
  }
  // Both sides on the edge, and none of its vertices left in the left column.
  bool done() const { return left_on_ && right_on_ && column(edge) != k_; }

  void look_ahead() {
    if (edge.last && edge.left == 0) return;
    next_edge = detail::edge_step(on(edge), edge);
    const remeshed_vertex name = detail::vertex_of(on(edge), next_edge.left);
    Data data = wrapped_sum(registers.at(role_edge).data, on(edge).step);
    // The end of the first edge is the beginning of the last.
    if (!next_edge.last && next_edge.left == 0) {
      next_edge = detail::edge_begin(frame.edge[1], true, next_edge.column, next_edge.row);
      data = frame.edge[1].begin;
    }
    registers.put(role_next_edge, name, data);
    ++additions_;
  }
  void advance_edge() {
    edge = next_edge;
    registers.assign(role_edge, role_next_edge);
    look_ahead();
  }

  void advance_upright() {
    upright = detail::edge_step(frame.upright, upright);
    const Data data = wrapped_sum(registers.at(role_upright).data, frame.upright.step);
    registers.put(role_upright, detail::vertex_of(frame.upright, upright.left), data);
    ++additions_;
  }
  // The grid vertex below + D_side.
  void put_above(walk_role role, walk_role grid) {
    remeshed_vertex name = registers[grid];
    name.t = wrap_to<formats::grid>(name.t + from_raw<two_signed>(frame.mirrored ? -1 : 1));
    const Data data = wrapped_sum(registers.at(grid).data, frame.side);
    registers.put(role, name, data);
    ++additions_;
  }
  void set_top_left(bool edge_here) {
    if (edge_here)
      registers.assign(role_top_left, role_edge);
    else
      put_above(role_top_left, role_left_grid);
  }
  void set_top_right(bool edge_there) {
    if (!edge_there)
      put_above(role_top_right, role_right_grid);
    else if (upright_)
      registers.assign(role_top_right, role_upright);
    else
      registers.assign(role_top_right, column(edge) == k_ ? role_next_edge : role_edge);
  }
  void move_left(bool edge_here) {
    registers.assign(role_left, role_top_left);
    if (!edge_here) {
      registers.assign(role_left_grid, role_top_left);
      ++left_row_;
      return;
    }
    left_row_ = edge.row;
    left_on_ = true;
    advance_edge();
  }
  void move_right(bool edge_there) {
    registers.assign(role_right, role_top_right);
    if (!edge_there) {
      registers.assign(role_right_grid, role_top_right);
      ++right_row_;
    } else if (upright_) {
      right_row_ = upright.row;
      right_on_ = upright.left == 0;
      if (!right_on_) advance_upright();
    } else {
      right_on_ = true;
    }
  }

  void put_out(primitive& out, Data (&data)[4], int i, walk_role role) const {
    out.v[i] = registers[role];
    data[i] = detail::of(out.v[i].kind) == corner_vertex ? Data() : registers.at(role).data;
  }
  // Counter-clockwise in the frame; the other way round where the frame turns against the base triangle.
  void triangle(primitive& out, Data (&data)[4], walk_role v0, walk_role v1, walk_role v2) const {
    out.quad = false;
    put_out(out, data, 0, v0);
    put_out(out, data, 1, frame.flip ? v2 : v1);
    put_out(out, data, 2, frame.flip ? v1 : v2);
    out.v[3] = remeshed_vertex();
    data[3] = Data();
  }
  void quad(primitive& out, Data (&data)[4]) const {
    out.quad = true;
    put_out(out, data, 0, role_left);
    put_out(out, data, 1, frame.flip ? role_top_left : role_right);
    put_out(out, data, 2, role_top_right);
    put_out(out, data, 3, frame.flip ? role_right : role_top_left);
  }

  using two_signed = format<2, 2, true>;
  std::int32_t k_ = 0;
  std::int32_t left_row_ = 0, right_row_ = 0;
  bool left_on_ = false, right_on_ = false;
  bool pointed_ = false, upright_ = false;
  int additions_ = 0;
};

using side_walk = side_walk_of<no_data>;

}  // namespace hls
}  // namespace relievo
