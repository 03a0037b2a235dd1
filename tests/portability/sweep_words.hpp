// sweep_words: a triangle through the entry points of the sweep, as text.
//   sweep(walk)   set-up and difference vertices; with walk, all primitives too, by name and with data
#pragma once
#include <memory>

#include "hls/sweep/sweep_line.hpp"
#include "tests/portability/records.hpp"

namespace relievo {
namespace {

// A small triangle anywhere, through the units of the sweep one after the other.
void sweep(bool walk) {
  hls::sweep_line_in corners;
  hls::primary_edge_in edges;
  hls::remeshing_plane_in projected;
  hls::case_selection_in cases;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t from = static_cast<std::int64_t>(next_random() % 60000) - 30000;
    for (int i = 0; i < 3; ++i) {
      corners.p[i][axis] = hls::from_raw<formats::grid>(from + static_cast<std::int64_t>(next_random() % 20));
      edges.p[i][axis] = projected.p[i][axis] = cases.p[i][axis] = corners.p[i][axis];
    }
  }
  const hls::sweep_setup setup = hls::set_up(corners);
  for (int i = 0; i < 3; ++i) {
    hls::main_direction_in ends;
    for (int axis = 0; axis < 3; ++axis) {
      ends.p[0][axis] = corners.p[i][axis];
      ends.p[1][axis] = corners.p[(i + 1) % 3][axis];
    }
    through<hls::main_direction_out>("main_direction", ends, relievo_main_direction);
    edges.axis[i] = setup.main[i].axis;
    edges.n[i] = setup.main[i].n;
  }
  through<hls::primary_edge_out>("primary_edge", edges, relievo_primary_edge);
  projected.edge = hls::primary_edge(edges).edge;
  projected.axis = edges.axis[hls::raw(projected.edge)];
  through<hls::remeshing_plane_out>("remeshing_plane", projected, relievo_remeshing_plane);
  cases.plane = setup.plane;
  through<hls::case_selection_out>("case_selection", cases, relievo_case_selection);

  // Any data at the corners: difference_vertices and the walk take what they are given.
  hls::interpolants data[9];
  for (hls::interpolants& corner : data) corner = random_record<hls::interpolants>();
  const auto data_port = std::make_unique<hls::port<hls::interpolants>>();
  hls::port<hls::interpolants>& data_in = *data_port;
  const auto write_data = [&] {
    for (hls::interpolants const& corner : data) data_in.write(hls::pack(corner));
  };
  hls::top::placed_triangle placed;
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) placed.p[i][axis] = corners.p[i][axis];
  placed.plane = setup.plane;
  write_data();
  through<hls::difference_vertices_out>("difference_vertices", placed,
                                        [&](hls::port<hls::top::placed_triangle>& in, hls::port<hls::difference_vertices_out>& out) {
                                          relievo_difference_vertices(in, data_in, out);
                                        });
  if (!walk) return;
  const auto in = std::make_unique<hls::port<hls::sweep_line_in>>();
  const auto out = std::make_unique<hls::port<hls::top::swept_primitive>>();
  in->write(hls::pack(corners));
  relievo_sweep_line(*in, *out);
  for (bool last = false; !last;) {
    const auto primitive = hls::unpack<hls::top::swept_primitive>(out->read());
    print_record("sweep_line", primitive);
    last = primitive.last;
  }
  const auto vertices = std::make_unique<hls::port<hls::top::swept_vertices>>();
  in->write(hls::pack(corners));
  write_data();
  relievo_sweep_vertices(*in, data_in, *vertices);
  for (bool last = false; !last;) {
    const auto primitive = hls::unpack<hls::top::swept_vertices>(vertices->read());
    print_record("sweep_vertices", primitive);
    last = primitive.last;
  }
}

}  // namespace
}  // namespace relievo
