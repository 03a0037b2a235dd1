// top: the synthesizable entry points, one .cpp each; what a host, a test or a tool's script calls.
//
//   One call of a unit takes one word and gives one word: the tool pipelines calls, initiation interval as the unit's header says.
//   One call of a builder is one map or one table, one of difference_vertices, sweep_line or sweep_vertices a triangle, one of the
//   engine a mesh: they loop over their input, and start fresh.
//   in, out    port<record>: one packed word a record (hls/core/packed.hpp: fields from bit 0 in their order, padded to 8 bits)
//   regs, map  packed too, constant while the call runs
//   memories   read-only words, one per texel, as hls/surface/map_regs.hpp says
//
//   Pragmas are written out in full and once per file: Bambu takes `mode=axis port=x` and refuses macros, the short form,
//   `s_axilite`, `port=return` and PIPELINE, hence the one question __BAMBU__.
#pragma once
#include "hls/core/port.hpp"
#include "hls/edge/engine.hpp"
#include "hls/surface/normal_map.hpp"
#include "hls/surface/summed_area_table.hpp"
#include "hls/sweep/base_triangle_clip.hpp"
#include "hls/sweep/grid_transform.hpp"
#include "hls/sweep/near_clip.hpp"
#include "hls/sweep/perspective_correction.hpp"
#include "hls/sweep/perspective_preparation.hpp"
#include "hls/sweep/sweep_line.hpp"
#include "hls/sweep/z_table.hpp"

namespace relievo {
namespace hls {
namespace top {

// The divider in the formats of the one division on the main path: clip / depth -> screen.
struct divide_in {
  fixed<formats::clip> numerator;
  fixed<formats::depth> denominator;
  RELIEVO_FIELDS(numerator, denominator)
};
struct divide_out {
  fixed<formats::screen> quotient;
  bool clipped;
  RELIEVO_FIELDS(quotient, clipped)
};

// A texel of a map, and a word of its summed-area table.
struct texel_word {
  fixed<formats::texel> d;
  RELIEVO_FIELDS(d)
};
struct table_word {
  fixed<formats::table_sum> sum;
  RELIEVO_FIELDS(sum)
};

// A base triangle: what the host knows of it. The engine adds the rest.
struct base_vertex {
  fixed<formats::position> p[3];
  fixed<formats::unit> n[3];
  fixed<formats::unit> t[3];
  fixed<formats::coordinate> u[2];
  RELIEVO_FIELDS(p, n, t, u)
};
struct base_triangle {
  base_vertex v[3];
  fixed<formats::index> index;
  bool last;
  RELIEVO_FIELDS(v, index, last)
};

// What the camera asks of the table of grid_transform.
struct z_table_regs {
  fixed<formats::kappa> kappa;
  RELIEVO_FIELDS(kappa)
};

// What the remeshing of a triangle puts out.
struct swept_primitive {
  primitive p;
  bool last;
  RELIEVO_FIELDS(p, last)
};

// A triangle on the grid and its plane. The data of its corners follow on a port of their own, nine words: corner[0..2], then the two
// ends of edge 0, of edge 1, of edge 2, as in difference_vertices_in.
struct placed_triangle {
  fixed<formats::grid> p[3][3];
  remeshing_plane_out plane;
  RELIEVO_FIELDS(p, plane)
};
// A primitive with the data of its vertices.
struct swept_vertices {
  primitive p;
  vertex_steps data[4];
  bool last;
  RELIEVO_FIELDS(p, data, last)
};

constexpr int queue_depth = 49;      // 3 M + 4 for the largest limit of generations, M = 15
constexpr int counter_words = 23;    // hls/edge/counters.hpp, in its order, splits[4] one after the other
constexpr int largest_width = 8192;  // texels in a line of the builders

// The triangle of which `corners` has the data.
inline difference_vertices_in with_corners(placed_triangle const& triangle, port<interpolants>& corners) {
  difference_vertices_in in;
  in.plane = triangle.plane;
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) in.p[i][axis] = triangle.p[i][axis];
  for (int i = 0; i < 3; ++i) in.corner[i] = unpack<interpolants>(corners.read());
  for (int edge = 0; edge < 3; ++edge)
    for (int end = 0; end < 2; ++end) in.end[edge][end] = unpack<interpolants>(corners.read());
  return in;
}

}  // namespace top
}  // namespace hls
}  // namespace relievo

extern "C" {
void relievo_divide(relievo::hls::port<relievo::hls::top::divide_in>& in, relievo::hls::port<relievo::hls::top::divide_out>& out);
void relievo_normalize(relievo::hls::port<relievo::hls::normalize_in>& in, relievo::hls::port<relievo::hls::normalize_out>& out);

void relievo_map_sampler(relievo::hls::port<relievo::hls::map_sampler_in>& in, relievo::hls::port_word<relievo::hls::map_regs> map,
                         std::uint16_t const* texels, relievo::hls::port<relievo::hls::map_sampler_out>& out);
void relievo_normal_sampler(relievo::hls::port<relievo::hls::normal_sampler_in>& in, relievo::hls::port_word<relievo::hls::map_regs> map,
                            std::uint64_t const* normals, relievo::hls::port<relievo::hls::normal_sampler_out>& out);
void relievo_summed_area_lookup(relievo::hls::port<relievo::hls::summed_area_lookup_in>& in,
                                relievo::hls::port_word<relievo::hls::map_regs> map, std::uint64_t const* table,
                                relievo::hls::port<relievo::hls::summed_area_lookup_out>& out);
void relievo_displace(relievo::hls::port<relievo::hls::displace_in>& in, relievo::hls::port_word<relievo::hls::displace_regs> regs,
                      relievo::hls::port<relievo::hls::displace_out>& out);
void relievo_bump(relievo::hls::port<relievo::hls::bump_in>& in, relievo::hls::port<relievo::hls::bump_out>& out);
void relievo_transform(relievo::hls::port<relievo::hls::transform_in>& in, relievo::hls::port_word<relievo::hls::transform_regs> regs,
                       relievo::hls::port<relievo::hls::transform_out>& out);
void relievo_transform_normal(relievo::hls::port<relievo::hls::transform_normal_in>& in,
                              relievo::hls::port_word<relievo::hls::transform_normal_regs> regs,
                              relievo::hls::port<relievo::hls::transform_normal_out>& out);
void relievo_summed_area_table(relievo::hls::port<relievo::hls::top::texel_word>& in, relievo::hls::port_word<relievo::hls::map_regs> map,
                               relievo::hls::port<relievo::hls::top::table_word>& out);
void relievo_normal_map(relievo::hls::port<relievo::hls::top::texel_word>& in, relievo::hls::port_word<relievo::hls::map_regs> map,
                        relievo::hls::port_word<relievo::hls::normal_map_regs> regs, relievo::hls::port<relievo::hls::normal_map_out>& out);

void relievo_normal_test(relievo::hls::port<relievo::hls::normal_test_in>& in, relievo::hls::port_word<relievo::hls::normal_test_regs> regs,
                         relievo::hls::port<relievo::hls::normal_test_out>& out);
void relievo_summed_height_test(relievo::hls::port<relievo::hls::summed_height_test_in>& in,
                                relievo::hls::port_word<relievo::hls::map_regs> map,
                                relievo::hls::port_word<relievo::hls::summed_height_test_regs> regs, std::uint64_t const* table,
                                relievo::hls::port<relievo::hls::summed_height_test_out>& out);
void relievo_view_test(relievo::hls::port<relievo::hls::view_test_in>& in, relievo::hls::port_word<relievo::hls::view_test_regs> regs,
                       relievo::hls::port<relievo::hls::view_test_out>& out);
void relievo_tex_coord_test(relievo::hls::port<relievo::hls::tex_coord_test_in>& in,
                            relievo::hls::port<relievo::hls::tex_coord_test_out>& out);
void relievo_highlight_test(relievo::hls::port<relievo::hls::highlight_test_in>& in,
                            relievo::hls::port_word<relievo::hls::highlight_test_regs> regs,
                            relievo::hls::port<relievo::hls::highlight_test_out>& out);
void relievo_profile_test(relievo::hls::port<relievo::hls::profile_test_in>& in, relievo::hls::port_word<relievo::hls::map_regs> map,
                          relievo::hls::port_word<relievo::hls::profile_test_regs> regs, std::uint16_t const* texels,
                          relievo::hls::port<relievo::hls::profile_test_out>& out);

void relievo_main_direction(relievo::hls::port<relievo::hls::main_direction_in>& in,
                            relievo::hls::port<relievo::hls::main_direction_out>& out);
void relievo_primary_edge(relievo::hls::port<relievo::hls::primary_edge_in>& in, relievo::hls::port<relievo::hls::primary_edge_out>& out);
void relievo_remeshing_plane(relievo::hls::port<relievo::hls::remeshing_plane_in>& in,
                             relievo::hls::port<relievo::hls::remeshing_plane_out>& out);
void relievo_case_selection(relievo::hls::port<relievo::hls::case_selection_in>& in,
                            relievo::hls::port<relievo::hls::case_selection_out>& out);
void relievo_near_clip(relievo::hls::port<relievo::hls::near_clip_in>& in, relievo::hls::port_word<relievo::hls::near_clip_regs> regs,
                       relievo::hls::port<relievo::hls::near_clip_out>& out);
void relievo_base_triangle_clip(relievo::hls::port<relievo::hls::base_triangle_clip_in>& in,
                                relievo::hls::port_word<relievo::hls::base_triangle_clip_regs> regs,
                                relievo::hls::port<relievo::hls::base_triangle_clip_out>& out);
void relievo_d_max_of(relievo::hls::port<relievo::hls::d_max_of_in>& in, relievo::hls::port_word<relievo::hls::map_regs> map,
                      relievo::hls::port_word<relievo::hls::displace_regs> regs, std::uint16_t const* maximum, std::uint16_t const* minimum,
                      relievo::hls::port<relievo::hls::d_max_of_out>& out);
void relievo_z_table(relievo::hls::port_word<relievo::hls::top::z_table_regs> regs, relievo::hls::port<relievo::hls::z_table_out>& out);
void relievo_grid_transform(relievo::hls::port<relievo::hls::grid_transform_in>& in,
                            relievo::hls::port_word<relievo::hls::grid_transform_regs> regs, std::int64_t const* z,
                            relievo::hls::port<relievo::hls::grid_transform_out>& out);
void relievo_perspective_preparation(relievo::hls::port<relievo::hls::perspective_preparation_in>& in,
                                     relievo::hls::port<relievo::hls::interpolants>& out);
void relievo_difference_vertices(relievo::hls::port<relievo::hls::top::placed_triangle>& in,
                                 relievo::hls::port<relievo::hls::interpolants>& corners,
                                 relievo::hls::port<relievo::hls::difference_vertices_out>& out);
void relievo_perspective_correction(relievo::hls::port<relievo::hls::perspective_correction_in>& in,
                                    relievo::hls::port_word<relievo::hls::perspective_correction_regs> regs,
                                    relievo::hls::port<relievo::hls::perspective_correction_out>& out);
void relievo_sweep_line(relievo::hls::port<relievo::hls::sweep_line_in>& in, relievo::hls::port<relievo::hls::top::swept_primitive>& out);
void relievo_sweep_vertices(relievo::hls::port<relievo::hls::sweep_line_in>& in, relievo::hls::port<relievo::hls::interpolants>& corners,
                            relievo::hls::port<relievo::hls::top::swept_vertices>& out);

void relievo_engine(relievo::hls::port<relievo::hls::top::base_triangle>& in, relievo::hls::port_word<relievo::hls::engine_regs> regs,
                    std::uint16_t const* texels, std::uint64_t const* table, std::uint64_t const* normals,
                    relievo::hls::port<relievo::hls::triangle_out>& out, std::uint64_t* counts);
}
