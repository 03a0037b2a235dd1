// displace_vertex: a vertex onto the displaced surface: reads D at its texture coordinate and moves it along its normal.
//   P'(u,v) = P + (s D(u,v) + b) N                            Doggett & Hirche 2000, eq. 1, section 3, Displace Vertex
//   in    p  position[3];  n  unit[3];  u  coordinate[2]
//   regs  map, displace;  memory displacement
//   out   p  position[3];  saturated
//   map_sampler then displace; one quad read; initiation interval 1 from a memory of four banks, 4 from one port
#pragma once
#include "hls/surface/displace.hpp"
#include "hls/surface/map_sampler.hpp"

namespace relievo {
namespace hls {

struct displace_vertex_in {
  fixed<formats::position> p[3];
  fixed<formats::unit> n[3];
  fixed<formats::coordinate> u[2];
  RELIEVO_FIELDS(p, n, u)
};
struct displace_vertex_out {
  fixed<formats::position> p[3];
  bool saturated;
  RELIEVO_FIELDS(p, saturated)
};

inline displace_vertex_out displace_vertex(displace_vertex_in const& in, map_regs const& map, displace_regs const& regs,
                                           texel_memory const& memory) {
  const map_sampler_out s0_sample = map_sampler({{in.u[0], in.u[1]}}, map, memory);
  const displace_out s1_moved = displace({{in.p[0], in.p[1], in.p[2]}, {in.n[0], in.n[1], in.n[2]}, s0_sample.d}, regs);
  return {{s1_moved.p[0], s1_moved.p[1], s1_moved.p[2]}, s1_moved.saturated};
}

}  // namespace hls
}  // namespace relievo
