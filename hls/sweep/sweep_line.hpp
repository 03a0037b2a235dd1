// sweep_line: all primitives of a triangle, in order.
//   Gumhold & Huettner 1999, 3.4, Figure 5 (the core of the remeshing), Figure 10
//   main_direction of each edge -> primary_edge -> remeshing_plane -> case_selection -> sub_triangle_remeshing, once or twice
//   in    p   grid[3][3], from -32767 to 32767
//         data  walk_data of the triangle, from difference_vertices; none for a walk of names alone, which sweep_line is
//   out   primitives: step() gives the next and says whether it is the last. All corners equal: the one triangle of corners 0, 1, 2.
//         With data those of its vertices too; of a corner and of what is no vertex they are 0.
//   Guarantees, by identity of the vertices: an edge of n steps has the vertices 0..n in any triangle that has the edge (n = 0: its two
//   corners); what lies between is without gap or overlap in the remeshing plane; corners on one line give triangles of no area.
//   exact; initiation interval 1: a primitive a clock without a pause, also from strip to strip and between the sub-triangles, so a
//   walk takes as many clocks as it has primitives. At most |det| + 3 n + n1 + n2 - 4 for n steps of the primary edge and n1, n2 of the
//   side edges (each at least 1): a disc with V vertices inside and n + n1 + n2 at its border has 2 V + n + n1 + n2 - 2 triangles; inside,
//   column s has at most h(s) + 1 grid vertices for a chord of h(s) rows, and the chords of the n - 1 columns between A and B add up to at
//   most |det| / 2.
#pragma once
#include "hls/sweep/primary_edge.hpp"
#include "hls/sweep/sub_triangle_remeshing.hpp"

namespace relievo {
namespace hls {

struct sweep_line_in {
  fixed<formats::grid> p[3][3];
  RELIEVO_FIELDS(p)
};

// What is known of a triangle before it is walked.
struct sweep_setup {
  main_direction_out main[3];
  remeshing_plane_out plane;
  case_selection_out cases;
  RELIEVO_FIELDS(main, plane, cases)
};

inline sweep_setup set_up(sweep_line_in const& in) {
  sweep_setup out;
  primary_edge_in edges;
  remeshing_plane_in projected;
  case_selection_in selected;
  for (int i = 0; i < 3; ++i) {
    main_direction_in ends;
    for (int axis = 0; axis < 3; ++axis) {
      ends.p[0][axis] = in.p[i][axis];
      ends.p[1][axis] = in.p[detail::after(i)][axis];
      edges.p[i][axis] = projected.p[i][axis] = selected.p[i][axis] = in.p[i][axis];
    }
    out.main[i] = main_direction(ends);
    edges.axis[i] = out.main[i].axis;
    edges.n[i] = out.main[i].n;
  }
  projected.edge = primary_edge(edges).edge;
  projected.axis = edges.axis[detail::of(projected.edge)];
  selected.plane = out.plane = remeshing_plane(projected);
  out.cases = case_selection(selected);
  return out;
}

template <class Data>
class sweep_line_of {
 public:
  void start(sweep_line_in const& in) { start(in, set_up(in), walk_data<Data>()); }
  void start(sweep_line_in const& in, sweep_setup const& setup, walk_data<Data> const& data) {
    for (int i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis) now_.p[i][axis] = in.p[i][axis];
    setup_ = setup;
    data_ = data;
    now_.plane = setup_.plane;
    second_ = !setup_.cases.sub[0].valid;
    if (detail::of(setup_.cases.kind) != point_case) start_sub();
  }

  // One clock, one primitive. Returns whether it was the last.
  bool step(primitive& out, Data (&data)[4]) {
    if (detail::of(setup_.cases.kind) == point_case) {
      out = primitive();
      for (int i = 0; i < 3; ++i) {
        out.v[i] = detail::corner_of(i);
        data[i] = Data();
      }
      data[3] = Data();
      return true;
    }
    if (!remeshing_.step(out, data)) return false;
    if (second_ || !setup_.cases.sub[1].valid) return true;
    second_ = true;
    start_sub();
    return false;
  }
  bool step(primitive& out) {
    Data data[4];
    return step(out, data);
  }

  sweep_setup const& setup() const { return setup_; }
  sub_triangle_remeshing_of<Data> const& remeshing() const { return remeshing_; }

 private:
  void start_sub() {
    now_.sub = setup_.cases.sub[second_ ? 1 : 0];
    remeshing_.start(now_, data_);
  }

  sub_triangle_remeshing_in now_;
  sweep_setup setup_;
  walk_data<Data> data_;
  sub_triangle_remeshing_of<Data> remeshing_;
  bool second_ = false;
};

using sweep_line = sweep_line_of<no_data>;

}  // namespace hls
}  // namespace relievo
