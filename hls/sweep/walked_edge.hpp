// walked_edge: an edge in the direction of a walk, and the place that the walk has reached on it.
//   Gumhold & Huettner 1999, 3.4.4
//   Rows and columns of edge vertices are floor(x + 1/2), by a DDA: e += 2 delta; when e leaves [0, 2n) the row steps and e comes back
//   by 2n. It ends exactly on the corner, and goes back as it came.
//   An edge of two equal corners has one step, of nothing. Data: begin, that of its first vertex; step, D_edge in the walk's direction.
//   Only additions and comparisons. All counters fit 18 bits: rows and columns 17, e and 2 delta 18.
//   exact; initiation interval 1
#pragma once
#include "hls/sweep/remeshed.hpp"

namespace relievo {
namespace hls {

// In the frame (s', t').
template <class Data>
struct walked_edge {
  std::int32_t n;
  std::int32_t two_n;
  std::int32_t d_column, d_row;  // 2 delta
  int from, to, number;
  bool rising;  // from the canonical end to the other
  Data begin, step;
};

// A vertex of the list of edges that is walked: one edge, or a vertical one and the last.
struct edge_place {
  bool last;          // on the last edge, its first vertex included
  std::int32_t left;  // steps to the end of the edge
  std::int32_t column, column_e, row, row_e;
};

namespace detail {

inline void dda_step(std::int32_t& q, std::int32_t& e, std::int32_t d, std::int32_t two_n) {
  e += d;
  if (e >= two_n) {
    e -= two_n;
    ++q;
  } else if (e < 0) {
    e += two_n;
    --q;
  }
}

template <class Data>
inline edge_place edge_begin(walked_edge<Data> const& edge, bool last, std::int32_t column, std::int32_t row) {
  return {last, edge.n, column, edge.n, row, edge.n};
}
// The vertex after this one, on the same edge.
template <class Data>
inline edge_place edge_step(walked_edge<Data> const& edge, edge_place place) {
  dda_step(place.column, place.column_e, edge.d_column, edge.two_n);
  dda_step(place.row, place.row_e, edge.d_row, edge.two_n);
  --place.left;
  return place;
}

inline remeshed_vertex corner_of(int corner) { return {two(corner_vertex), two(corner), {}, {}, {}}; }
template <class Data>
inline remeshed_vertex vertex_of(walked_edge<Data> const& edge, std::int32_t left) {
  if (left == edge.n) return corner_of(edge.from);
  if (left == 0) return corner_of(edge.to);
  return {two(edge_vertex), two(edge.number), from_raw<formats::steps>(edge.rising ? edge.n - left : left), {}, {}};
}

}  // namespace detail

}  // namespace hls
}  // namespace relievo
