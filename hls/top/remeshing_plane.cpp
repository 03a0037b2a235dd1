// remeshing_plane: plane and corners of a triangle. Entry point of hls/sweep/remeshing_plane.hpp.
//   in       152 bits  p 3 x 3 x 16, edge 2, axis 2
//   out       48 bits  s, t, a, b, c 2 each, det 35, mirrored 1
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<remeshing_plane_in>::value == 148, "the layout above");
static_assert(field_width<remeshing_plane_out>::value == 46, "the layout above");

void relievo_remeshing_plane(port<remeshing_plane_in>& in, port<remeshing_plane_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(remeshing_plane(unpack<remeshing_plane_in>(in.read()))));
}
