// primary_edge: the edge along which the sweep line moves. Entry point of hls/sweep/primary_edge.hpp.
//   in       200 bits  p 3 x 3 x 16, axis 3 x 2, n 3 x 16
//   out        8 bits  edge 2
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<primary_edge_in>::value == 198, "the layout above");
static_assert(field_width<primary_edge_out>::value == 2, "the layout above");

void relievo_primary_edge(port<primary_edge_in>& in, port<primary_edge_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(primary_edge(unpack<primary_edge_in>(in.read()))));
}
