// side_walk: one strip of a sub-triangle, between the columns k and k+1 of s'.          Gumhold & Huettner 1999, section 3.4.4
//
//   Each column is a list of places, from the bottom up, every one with the row of the grid point that it stands for:
//     left    P_k; the grid points above it, below the first side vertex of column k; all side vertices of column k
//     right   P_(k+1); the grid points above it, below the first side vertex of column k+1; that vertex
//   A side vertex whose row is no higher than the one above the foot takes its place at once. Where the walk begins at a corner
//   the left column has side vertices alone. On a vertical end edge the right column is that edge. Where the sub-triangle is
//   pointed the right column is the corner alone, and the left one ends before the first vertex of the last side edge.
//
//   The strip joins the two lists. Of the two next places it takes
//     the left one     where the side vertex after it has the same row (a double step: the left row stays)
//     the only one     where one list is used up
//     the left one     where its row is no higher than the left row
//     the lower one's  next where the rows differ, and both, as a quad, where they are equal
//   and a pointed one closes with a fan from the last left place over the rest of the side vertices to the corner.
//
// A vertical side edge needs no rule of its own: its part of det is that of its height, so the plane of the larger area has its
// main direction as t, ties included, and each of its vertices is a row above the one before.
//
//   in   strip   k; the feet P_k and P_(k+1); where the side edge stands; flags
//   out  primitives, appended; and where the side edge stands: at the first vertex right of column k
//
// Error: std::logic_error where the side edge has no vertex in a column, which no edge with the right columns is.
#pragma once
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "golden/sweep/remeshed.hpp"

namespace relievo {
namespace golden {

// s' = sign_s s, t' = sign_t t; mirrored: counter-clockwise here is the other way round in the remeshing plane, seen from the
// base triangle's corners.
struct sweep_frame {
  std::int64_t sign_s = 1, sign_t = 1;
  bool mirrored = false;
};

// A vertex and the grid point that it stands for, in s' and t'.
struct place {
  remeshed_vertex vertex;
  std::int64_t column = 0, row = 0;
  bool on_last_edge = false;
};

struct side_walk_in {
  std::int64_t k = 0;
  place left, right;
  bool starts_at_corner = false, pointed = false, ends_on_edge = false;
  std::size_t at = 0;
};

namespace detail {

inline place grid_place(sweep_frame const& frame, std::int64_t column, std::int64_t row) {
  place p;
  p.vertex = {kind_grid, 0, 0, static_cast<double>(frame.sign_s * column), static_cast<double>(frame.sign_t * row)};
  p.column = column;
  p.row = row;
  return p;
}

inline primitive triangle_of(sweep_frame const& frame, place const& l, place const& r, place const& top) {
  if (frame.mirrored) return {false, {l.vertex, top.vertex, r.vertex, {}}};
  return {false, {l.vertex, r.vertex, top.vertex, {}}};
}
inline primitive quad_of(sweep_frame const& frame, place const& l, place const& r, place const& top_r, place const& top_l) {
  if (frame.mirrored) return {true, {l.vertex, top_l.vertex, top_r.vertex, r.vertex}};
  return {true, {l.vertex, r.vertex, top_r.vertex, top_l.vertex}};
}

// The grid points strictly between the foot's row and that of the side vertex.
inline std::vector<place> grid_column(sweep_frame const& frame, place const& foot, std::int64_t column, place const& side) {
  std::vector<place> list;
  for (std::int64_t row = foot.row + 1; row < side.row; ++row) list.push_back(grid_place(frame, column, row));
  return list;
}

// What joins the two columns above their feet. The left foot is moved to the last left place.
inline void join(sweep_frame const& frame, place& l, std::vector<place> const& left, place r, std::vector<place> const& right,
                 std::vector<primitive>& out) {
  std::int64_t rl = l.row, rr = r.row;
  std::size_t i = 0, j = 0;
  while (i < left.size() || j < right.size()) {
    const bool double_step = i + 1 < left.size() && left[i].row == left[i + 1].row;
    bool take_left = i < left.size(), take_right = j < right.size();
    if (double_step) {
      take_right = false;
    } else if (take_left && take_right) {
      const bool left_level = left[i].row <= rl;
      take_left = left_level || rl <= rr;
      take_right = !left_level && rl >= rr;
    }
    if (take_left && take_right)
      out.push_back(quad_of(frame, l, r, right[j], left[i]));
    else
      out.push_back(triangle_of(frame, l, r, take_left ? left[i] : right[j]));
    if (take_left) {
      l = left[i++];
      if (!double_step) rl = l.row;
    }
    if (take_right) {
      r = right[j++];
      rr = r.row;
    }
  }
}

}  // namespace detail

// side: the vertices of the side edge in the direction of the walk;  end_edge: those of a vertical end edge, bottom corner first
inline std::size_t side_walk(sweep_frame const& frame, side_walk_in const& in, std::vector<place> const& side,
                             std::vector<place> const& end_edge, std::vector<primitive>& out) {
  std::size_t next = in.at;
  if (!in.starts_at_corner && side[next].column != in.k) throw std::logic_error("side_walk: no side vertex in the left column");

  std::vector<place> left;
  if (!in.starts_at_corner) left = detail::grid_column(frame, in.left, in.k, side[next]);
  while (side[next].column == in.k && !(in.pointed && side[next].on_last_edge)) left.push_back(side[next++]);

  std::vector<place> right;
  if (in.ends_on_edge) {
    right.assign(end_edge.begin() + 1, end_edge.end());
  } else if (!in.pointed) {
    if (side[next].column != in.k + 1) throw std::logic_error("side_walk: no side vertex in the right column");
    right = detail::grid_column(frame, in.right, in.k + 1, side[next]);
    right.push_back(side[next]);
  }

  place l = in.left;
  detail::join(frame, l, left, in.right, right, out);
  if (in.pointed)
    for (; next + 1 < side.size(); ++next) out.push_back(detail::triangle_of(frame, l, side[next + 1], side[next]));
  return next;
}

}  // namespace golden
}  // namespace relievo
