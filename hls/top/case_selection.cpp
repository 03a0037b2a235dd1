// case_selection: the two sub-triangles of a triangle. Entry point of hls/sweep/case_selection.hpp.
//   in       192 bits  p 3 x 3 x 16, plane 46
//   out       96 bits  kind 2, sub 2 x 44
//   one word in, one word out a call; initiation interval 1
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<case_selection_in>::value == 190, "the layout above");
static_assert(field_width<case_selection_out>::value == 90, "the layout above");

void relievo_case_selection(port<case_selection_in>& in, port<case_selection_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
#endif
  // clang-format on
  out.write(pack(case_selection(unpack<case_selection_in>(in.read()))));
}
