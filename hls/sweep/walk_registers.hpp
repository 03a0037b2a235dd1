// walk_registers: the twelve vertices of a walk, addressed by a four-bit index.
//   Gumhold & Huettner 1999, 3.4.4: a role names a register, several may name the same, and an assignment copies the index.
//     paper     role                            paper     role
//     V_start   start: P_(k+1)                  v_bl, vbr left, right
//     V_base    base: its grid point            v_tl, vtr top_left, top_right (no_vertex, above eleven, where invalid)
//     V_edge    edge; ours: next_edge, the one after it; upright, the next one of a vertical edge at the end
//     ours      left_grid, right_grid: the grid point below, which is base or the vertex itself
//   The paper's D_primary, D_edge, D_sweep, D_side are what the additions add; of a name that is 1 (steps, columns, rows), of
//   vertex data they are difference_vertices. V_end is the last column, k1.
//   A register holds a name and Data, vertex_steps or no_data (hls/sweep/walk_data.hpp).
//   Comparisons alone; initiation interval 1
#pragma once
#include "hls/sweep/remeshed.hpp"

namespace relievo {
namespace hls {

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

template <class Data>
struct walked_vertex {
  remeshed_vertex name;
  Data data;
};

template <class Data>
class walk_registers {
 public:
  walk_registers() {
    for (int role = 0; role < walk_roles; ++role) index_[role] = no_vertex;
  }
  int index(walk_role role) const { return index_[role]; }
  walked_vertex<Data> const& at(walk_role role) const { return vertex_[index_[role]]; }
  remeshed_vertex const& operator[](walk_role role) const { return at(role).name; }
  void assign(walk_role to, walk_role from) { index_[to] = index_[from]; }
  void invalidate(walk_role role) { index_[role] = no_vertex; }
  // Into a register that no other role names: eleven roles leave one of twelve free.
  void put(walk_role role, remeshed_vertex const& name, Data const& data) {
    index_[role] = no_vertex;
    bool named[16] = {};
    for (int other = 0; other < walk_roles; ++other) named[index_[other]] = true;
    int free = 0;
    for (int i = walk_registers_count - 1; i >= 0; --i)
      if (!named[i]) free = i;
    vertex_[free] = {name, data};
    index_[role] = free;
  }

 private:
  walked_vertex<Data> vertex_[walk_registers_count];
  int index_[walk_roles];
};

}  // namespace hls
}  // namespace relievo
