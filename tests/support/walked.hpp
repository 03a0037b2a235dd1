// walked: what the walk's circuits put out, and what a data path makes of it.
//   walked                       walked_t of rtl/sweep/walk_pkg.sv
//   walked_by(kernel, in)        the kernel's primitives and where strips and sub-triangles end; of the moves it says nothing
//   walked_vertex_word, walked_strip  edge_vertex_t and strip_t there
//   same_names(rtl, hls)         all but the moves
//   data_path(setup, data)       follows the moves step by step: data of the vertices of a primitive, additions alone
#pragma once
#include "hls/sweep/sweep_line.hpp"
#include "tests/support/remeshed_mesh.hpp"
#include "tests/support/stream_unit.hpp"

namespace relievo::test {

struct walked_way {
  hls::two_bits number;
  bool rising;
  RELIEVO_FIELDS(number, rising)
};
struct walked_choice {
  bool advance, edge_there, edge_here, go_right, go_left, twice, fan, on_edge;
  RELIEVO_FIELDS(advance, edge_there, edge_here, go_right, go_left, twice, fan, on_edge)
};
struct walked_moves {
  walked_choice now;
  walked_way upright;
  bool edge_begins;
  walked_way edge_way, primary;
  bool flip, mirrored, backward;
  hls::fixed<format<2, 2, true>> rows;
  bool from_corner, begins, first;
  RELIEVO_FIELDS(now, upright, edge_begins, edge_way, primary, flip, mirrored, backward, rows, from_corner, begins, first)
};
struct walked {
  hls::primitive out;
  walked_moves moves;
  bool strip_last, sub_last, last;
  RELIEVO_FIELDS(out, moves, strip_last, sub_last, last)
};

struct walked_border {
  hls::fixed<formats::steps> i;
  hls::two_bits number;
  bool on_edge;
  RELIEVO_FIELDS(i, number, on_edge)
};
struct walked_vertex_word {
  bool first_column, first_row, column, row, only_end, before_end, last, begins;
  walked_way along;
  walked_border name;
  RELIEVO_FIELDS(first_column, first_row, column, row, only_end, before_end, last, begins, along, name)
};
struct walked_strip_kind {
  bool flip, mirrored, backward, on_edge, pointed, ends, last, from_corner, begins, point;
  RELIEVO_FIELDS(flip, mirrored, backward, on_edge, pointed, ends, last, from_corner, begins, point)
};
struct walked_strip {
  hls::fixed<formats::steps> upright_n;
  walked_way upright;
  hls::fixed<formats::grid> right_t, right_s, left_t, left_s;
  walked_border right, left;
  hls::two_bits to;
  walked_way primary;
  hls::fixed<format<2, 2, true>> rows;
  walked_strip_kind kind;
  RELIEVO_FIELDS(upright_n, upright, right_t, right_s, left_t, left_s, right, left, to, primary, rows, kind)
};

inline testing::AssertionResult same_names(walked const& rtl, walked const& hls) {
  walked named = rtl;
  named.moves = hls.moves;
  return same_words(named, hls);
}

// The next primitive of a walk that was started.
template <class Walk, class Data>
walked next_of(Walk& walk, Data (&data)[4]) {
  auto const& remeshing = walk.remeshing();
  auto const& frame = remeshing.walk().frame;
  const int column = remeshing.column();
  const bool backward = frame.backward, pointed = frame.pointed;
  walked w{};
  w.last = walk.step(w.out, data);
  // The next sub-triangle is started in the clock in which one ends.
  w.sub_last = w.last || frame.backward != backward || frame.pointed != pointed;
  w.strip_last = w.sub_last || remeshing.column() != column;
  return w;
}
inline std::vector<walked> walked_by(hls::sweep_line& walk, hls::sweep_line_in const& in) {
  std::vector<walked> list;
  walk.start(in);
  hls::no_data none[4];
  do list.push_back(next_of(walk, none));
  while (!list.back().last);
  return list;
}

class data_path {
 public:
  using vertex = hls::vertex_steps;
  void start(hls::walk_data<vertex> const& data) { data_ = data; }

  // Of the vertices of w, that of a corner is 0.
  void step(walked const& w, vertex (&out)[4]) {
    walked_moves const& m = w.moves;
    const vertex side = m.mirrored ? minus(data_.side) : data_.side;
    if (m.first) {
      if (m.from_corner) {
        start_ = begin_of(m.primary);
        base_ = data_.base[m.backward ? 1 : 0];
      }
      left_ = start_;
      left_grid_ = base_;
      start_ = hls::wrapped_sum(start_, step_of(m.primary));
      base_ = hls::wrapped_sum(base_, m.backward ? minus(data_.sweep) : data_.sweep);
      if (raw(m.rows) > 0) base_ = hls::wrapped_sum(base_, side);
      if (raw(m.rows) < 0) base_ = hls::wrapped_difference(base_, side);
      right_ = start_;
      right_grid_ = base_;
      if (m.now.on_edge) upright_ = hls::wrapped_sum(begin_of(m.upright), step_of(m.upright));
    }
    if (m.edge_begins)
      edge_ = begin_of(m.edge_way);
    else if (m.begins)
      edge_ = hls::wrapped_sum(begin_of(m.edge_way), step_of(m.edge_way));
    const vertex next = hls::wrapped_sum(edge_, step_of(m.edge_way));

    vertex top_left = edge_, top_right = m.now.on_edge ? upright_ : m.now.edge_here ? next : edge_;
    if (m.now.go_left && !m.now.edge_here) top_left = left_grid_ = hls::wrapped_sum(left_grid_, side);
    if (m.now.go_right && !m.now.edge_there) top_right = right_grid_ = hls::wrapped_sum(right_grid_, side);
    const bool quad = m.now.go_left && m.now.go_right;
    const vertex second = m.now.fan ? next : right_, third = m.now.fan || m.now.twice ? edge_ : m.now.go_left ? top_left : top_right;
    out[0] = left_;
    out[1] = m.flip ? third : second;
    out[2] = quad ? top_right : m.flip ? second : third;
    out[3] = m.flip ? second : third;
    for (int i = 0; i < 4; ++i)
      if (raw(w.out.v[i].kind) == hls::corner_vertex) out[i] = vertex();

    if (m.now.twice) left_ = edge_;
    if (m.now.go_left) left_ = top_left;
    if (m.now.go_right) right_ = top_right;
    if (m.now.go_right && m.now.on_edge) upright_ = hls::wrapped_sum(upright_, step_of(m.upright));
    if (m.now.advance) edge_ = next;
  }

 private:
  static vertex minus(vertex const& v) { return hls::wrapped_difference(vertex(), v); }
  vertex begin_of(walked_way const& way) const { return data_.end[raw(way.number)][way.rising ? 0 : 1]; }
  vertex step_of(walked_way const& way) const { return way.rising ? data_.step[raw(way.number)] : minus(data_.step[raw(way.number)]); }

  hls::walk_data<vertex> data_;
  vertex start_, base_, left_, right_, left_grid_, right_grid_, edge_, upright_;
};

}  // namespace relievo::test
