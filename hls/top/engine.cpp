// engine: base triangles in, adaptively tessellated and displaced triangles out. Entry point of hls/edge/engine.hpp.
//   in       688 bits  three vertices of p 3 x 24, n 3 x 16, t 3 x 16, u 2 x 25; index 32, last 1
//   regs     928 bits  the records of hls/edge/engine_regs.hpp one after the other
//   texels    16 bits a texel, displacement;  table  64 bits a texel, the low 40 a word of the summed-area table
//   normals   64 bits a texel, three 16-bit components from bit 0
//   out     1272 bits  three vertices of p 3 x 24, t 3 x 16, u 2 x 25, displaced_p 3 x 24, displaced_n 3 x 16, screen 2 x 22, w 28,
//                      behind 1, screen_n 3 x 16, away 1; index 32, empty 1, last 1
//   counts   64 bits each, counter_words of them, when the mesh is done
//   one mesh a call; sequential, one triangle in flight
#include "hls/core/streaming_loop.hpp"
#include "hls/top/top.hpp"

using namespace relievo::hls;

static_assert(field_width<top::base_triangle>::value == 687, "the layout above");
static_assert(field_width<engine_regs>::value == 925, "the layout above");
static_assert(field_width<triangle_out>::value == 1270, "the layout above");

namespace {

// The engine reads and writes records; the ports carry words.
struct source {
  port<top::base_triangle>& port_in;
  triangle read() {
    const top::base_triangle base = unpack<top::base_triangle>(port_in.read());
    triangle t = triangle();
    for (int i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        t.v[i].p[axis] = base.v[i].p[axis];
        t.v[i].n[axis] = base.v[i].n[axis];
        t.v[i].t[axis] = base.v[i].t[axis];
      }
      t.v[i].u[0] = base.v[i].u[0];
      t.v[i].u[1] = base.v[i].u[1];
    }
    t.index = base.index;
    t.last = base.last;
    return t;
  }
};
struct sink {
  port<triangle_out>& port_out;
  void write(triangle_out const& t) { port_out.write(pack(t)); }
};

struct count_writer {
  std::uint64_t* counts;
  int at;
  void operator()(char const*, std::uint64_t count) { counts[at++] = count; }
  template <int N>
  void operator()(char const*, std::uint64_t const (&count)[N]) {
    for (int i = 0; i < N; ++i) counts[at++] = count[i];
  }
};

}  // namespace

void relievo_engine(port<top::base_triangle>& in, port_word<engine_regs> regs, std::uint16_t const* texels, std::uint64_t const* table,
                    std::uint64_t const* normals, port<triangle_out>& out, std::uint64_t* counts) {
  // clang-format off
#pragma HLS INTERFACE mode=axis port=in
#pragma HLS INTERFACE mode=axis port=out
#ifndef __BAMBU__
#pragma HLS INTERFACE mode=s_axilite port=regs
#pragma HLS INTERFACE mode=m_axi port=texels offset=slave bundle=texels
#pragma HLS INTERFACE mode=m_axi port=table offset=slave bundle=table
#pragma HLS INTERFACE mode=m_axi port=normals offset=slave bundle=normals
#pragma HLS INTERFACE mode=m_axi port=counts offset=slave bundle=counts
#pragma HLS INTERFACE mode=s_axilite port=return
#else
#pragma HLS INTERFACE mode=m_axi port=texels offset=direct
#pragma HLS INTERFACE mode=m_axi port=table offset=direct
#pragma HLS INTERFACE mode=m_axi port=normals offset=direct
#pragma HLS INTERFACE mode=m_axi port=counts offset=direct
#endif
  // clang-format on
  const engine_regs constants = unpack<engine_regs>(regs);
  const engine_memories memories = {{texels}, {table}, {normals}};
  source base = {in};
  sink mesh = {out};
  engine<top::queue_depth> kernel;
  kernel.start();
  while (!kernel.done()) {
    RELIEVO_STREAMING_LOOP("one turn per triangle; ends after the record that says last went out");
    kernel.step(base, mesh, constants, memories);
  }
  count_writer writer = {counts, 0};
  kernel.counts().each_field(writer);
}
