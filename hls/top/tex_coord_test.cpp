// tex_coord_test: ct of an edge. Entry point of hls/edge/tex_coord_test.hpp.
//   in       152 bits  u1, u2, u12 2 x 25 each
//   out        8 bits  ct 1
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<tex_coord_test_in>::value == 150, "the layout above");
static_assert(field_width<tex_coord_test_out>::value == 1, "the layout above");

void relievo_tex_coord_test(port<tex_coord_test_in>& in, port<tex_coord_test_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(tex_coord_test(unpack<tex_coord_test_in>(in.read()))));
}
