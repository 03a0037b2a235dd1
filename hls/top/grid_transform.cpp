// grid_transform: a screen position and its depth to the grid. Entry point of hls/sweep/grid_transform.hpp.
//   in     72 bits  screen 2 x 22, w 28
//   regs  104 bits  cells_per_pixel 24, octave 40, near_cells 40
//   z      64 bits a word, 257 of them: depth_cells, its sign in all bits above 40
//   out    56 bits  p 3 x 16, saturated 1
//   one word in, one word out a call; initiation interval 2 with this one-word port
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<grid_transform_in>::value == 72, "the layout above");
static_assert(field_width<grid_transform_regs>::value == 104, "the layout above");
static_assert(field_width<grid_transform_out>::value == 49, "the layout above");

void relievo_grid_transform(port<grid_transform_in>& in, port_word<grid_transform_regs> regs, std::int64_t const* z,
                            port<grid_transform_out>& out) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=m_axi port=z offset=slave bundle=z
#pragma HLS INTERFACE mode=s_axilite port=return
#pragma HLS PIPELINE II=2
#else
#pragma HLS INTERFACE mode=m_axi port=z offset=direct
#endif
  // clang-format on
  out.write(pack(grid_transform(unpack<grid_transform_in>(in.read()), unpack<grid_transform_regs>(regs), z_memory{z})));
}
