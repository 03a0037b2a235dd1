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
//   Row: that of the grid point from which a vertex was dragged. Rows and columns of edge vertices are floor(x + 1/2), by a DDA:
//   e += 2 delta; when e leaves [0, 2n) the row steps and e comes back by 2n. It ends exactly on the corner, and goes back as it came.
//
//   Twelve registers, addressed by a four-bit index; a role names one, several may name the same, and an assignment copies the index.
//     paper     role                            paper     role
//     V_start   start: P_(k+1)                  v_bl, vbr left, right
//     V_base    base: its grid point            v_tl, vtr top_left, top_right (no_vertex, above eleven, where invalid)
//     V_edge    edge; ours: next_edge, the one after it; upright, the next one of a vertical edge at the end
//     ours      left_grid, right_grid: the grid point below, which is base or the vertex itself
//   The paper's D_primary, D_edge, D_sweep, D_side are what the additions add; of a name that is 1 (steps, columns, rows), of
//   vertex data they are difference_vertices. V_end is the last column, k1.
//
//   Only additions and comparisons. A step writes at most three registers: top_left, top_right and the edge vertex after the next.
//   All counters fit 18 bits: rows and columns 17, e and 2 delta 18.
//   initiation interval 1; every step but none else puts out a primitive, so a strip takes as many clocks as it has primitives
#pragma once
#include "hls/core/additions_only.hpp"
#include "hls/sweep/remeshed.hpp"

namespace relievo {
namespace hls {

// ---- the side edge ------------------------------------------------------------------------------------------------------

// An edge in the direction of the walk, in the frame (s', t'). An edge of two equal corners has one step, of nothing.
struct walked_edge {
  std::int32_t n;
  std::int32_t two_n;
  std::int32_t d_column, d_row;  // 2 delta
  int from, to, number;
  bool rising;  // from the canonical end to the other
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

inline edge_place edge_begin(walked_edge const& edge, bool last, std::int32_t column, std::int32_t row) {
  return {last, edge.n, column, edge.n, row, edge.n};
}
// The vertex after this one, on the same edge.
inline edge_place edge_step(walked_edge const& edge, edge_place place) {
  dda_step(place.column, place.column_e, edge.d_column, edge.two_n);
  dda_step(place.row, place.row_e, edge.d_row, edge.two_n);
  --place.left;
  return place;
}

inline remeshed_vertex corner_of(int corner) { return {two(corner_vertex), two(corner), {}, {}, {}}; }
inline remeshed_vertex vertex_of(walked_edge const& edge, std::int32_t left) {
  if (left == edge.n) return corner_of(edge.from);
  if (left == 0) return corner_of(edge.to);
  return {two(edge_vertex), two(edge.number), from_raw<formats::steps>(edge.rising ? edge.n - left : left), {}, {}};
}

}  // namespace detail

// ---- the registers ------------------------------------------------------------------------------------------------------

enum walk_role {
  role_start,
  role_base,
  role_left,
  role_right,
  role_top_left,
  role_top_right,
  role_left_grid,
  role_right_grid,
  role_edge,
  role_next_edge,
  role_upright,
  walk_roles
};
constexpr int walk_registers_count = 12;
constexpr int no_vertex = 15;

class walk_registers {
 public:
  walk_registers() {
    for (int role = 0; role < walk_roles; ++role) index_[role] = no_vertex;
  }
  int index(walk_role role) const { return index_[role]; }
  remeshed_vertex const& operator[](walk_role role) const { return vertex_[index_[role]]; }
  void assign(walk_role to, walk_role from) { index_[to] = index_[from]; }
  void invalidate(walk_role role) { index_[role] = no_vertex; }
  // Into a register that no other role names: eleven roles leave one of twelve free.
  void put(walk_role role, remeshed_vertex const& vertex) {
    index_[role] = no_vertex;
    bool named[16] = {};
    for (int other = 0; other < walk_roles; ++other) named[index_[other]] = true;
    int free = 0;
    for (int i = walk_registers_count - 1; i >= 0; --i)
      if (!named[i]) free = i;
    vertex_[free] = vertex;
    index_[role] = free;
  }

 private:
  remeshed_vertex vertex_[walk_registers_count];
  int index_[walk_roles];
};

// ---- the walk -----------------------------------------------------------------------------------------------------------

// What holds for a sub-triangle as long as it is walked.
struct walk_frame {
  bool backward;        // s' = -s
  bool mirrored;        // t' = -t
  bool flip;            // the frame turns against the base triangle
  bool pointed;         // the last strip points to a corner
  bool ends_on_edge;    // the last strip ends on a vertical edge
  std::int32_t k1;      // last column
  walked_edge edge[2];  // the list: edge[0] where it has two; edge[1] is the last
  walked_edge upright;  // the vertical edge at the end
};

class side_walk {
 public:
  // ---- for the outer loop
  walk_frame frame;
  walk_registers registers;
  edge_place edge, next_edge, upright;

  // E is the first vertex of the list, or the one after it where the walk starts in the first.
  void begin_edge(edge_place const& first, bool starts_there) {
    edge = first;
    registers.put(role_edge, detail::vertex_of(on(edge), edge.left));
    look_ahead();
    if (starts_there) advance_edge();
  }
  void begin_upright(edge_place const& corner) {
    upright = corner;
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

  // One clock, one primitive. Returns whether it was the strip's last.
  bool step(primitive& out) {
    RELIEVO_ADDITIONS_ONLY("the inner loop");
    registers.invalidate(role_top_left);
    registers.invalidate(role_top_right);
    additions_ = 0;
    const bool edge_here = column(edge) == k_ && (left_on_ || edge.row <= left_row_ + 1);
    if (pointed_ && edge_here && edge.last) {
      triangle(out, role_left, role_next_edge, role_edge);
      advance_edge();
      return edge.left == 0;
    }
    if (edge_here && column(next_edge) == k_ && next_edge.row == edge.row) {
      triangle(out, role_left, role_right, role_edge);
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
      quad(out);
    else
      triangle(out, role_left, role_right, left ? role_top_left : role_top_right);
    if (left) move_left(edge_here);
    if (right) move_right(edge_there);
    return done();
  }

  // Vector additions of this clock; the outer loop adds those of a strip's start.
  int additions() const { return additions_; }
  void count_additions(int more) { additions_ += more; }

 private:
  walked_edge const& on(edge_place const& place) const { return frame.edge[place.last ? 1 : 0]; }
  // All but the end stay before the last column.
  std::int32_t column(edge_place const& place) const {
    return place.column == frame.k1 && !(place.last && place.left == 0) ? frame.k1 - 1 : place.column;
  }
  // Both sides on the edge, and none of its vertices left in the left column.
  bool done() const { return left_on_ && right_on_ && column(edge) != k_; }

  void look_ahead() {
    if (edge.last && edge.left == 0) return;
    next_edge = detail::edge_step(on(edge), edge);
    registers.put(role_next_edge, detail::vertex_of(on(edge), next_edge.left));
    // The end of the first edge is the beginning of the last.
    if (!next_edge.last && next_edge.left == 0) next_edge = detail::edge_begin(frame.edge[1], true, next_edge.column, next_edge.row);
    ++additions_;
  }
  void advance_edge() {
    edge = next_edge;
    registers.assign(role_edge, role_next_edge);
    look_ahead();
  }

  void advance_upright() {
    upright = detail::edge_step(frame.upright, upright);
    registers.put(role_upright, detail::vertex_of(frame.upright, upright.left));
    ++additions_;
  }
  // The grid vertex below + D_side.
  remeshed_vertex above(walk_role grid) {
    remeshed_vertex vertex = registers[grid];
    vertex.t = wrap_to<formats::grid>(vertex.t + from_raw<two_signed>(frame.mirrored ? -1 : 1));
    ++additions_;
    return vertex;
  }
  void set_top_left(bool edge_here) {
    if (edge_here)
      registers.assign(role_top_left, role_edge);
    else
      registers.put(role_top_left, above(role_left_grid));
  }
  void set_top_right(bool edge_there) {
    if (!edge_there)
      registers.put(role_top_right, above(role_right_grid));
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

  // Counter-clockwise in the frame; the other way round where the frame turns against the base triangle.
  void triangle(primitive& out, walk_role v0, walk_role v1, walk_role v2) const {
    out.quad = false;
    out.v[0] = registers[v0];
    out.v[1] = registers[frame.flip ? v2 : v1];
    out.v[2] = registers[frame.flip ? v1 : v2];
    out.v[3] = remeshed_vertex();
  }
  void quad(primitive& out) const {
    out.quad = true;
    out.v[0] = registers[role_left];
    out.v[1] = registers[frame.flip ? role_top_left : role_right];
    out.v[2] = registers[role_top_right];
    out.v[3] = registers[frame.flip ? role_right : role_top_left];
  }

  using two_signed = format<2, 2, true>;
  std::int32_t k_ = 0;
  std::int32_t left_row_ = 0, right_row_ = 0;
  bool left_on_ = false, right_on_ = false;
  bool pointed_ = false, upright_ = false;
  int additions_ = 0;
};

}  // namespace hls
}  // namespace relievo
