// map_words: what the read ports of the map memories carry (rtl/surface/memory_pkg.sv), as records.
//   quad_request -> texel_quad, normal_quad;  table_request -> table_word;  group<Record, N>: N of them, asked for and answered together
#pragma once
#include "hls/core/packed.hpp"
#include "hls/core/record.hpp"

namespace relievo::tb {

struct quad_request {
  hls::fixed<formats::map_size> x[2];
  hls::fixed<formats::map_size> y[2];
  RELIEVO_FIELDS(x, y)
};
// [row][column]
struct texel_quad {
  hls::fixed<formats::texel> q[2][2];
  RELIEVO_FIELDS(q)
};
// [row][column][component]
struct normal_quad {
  hls::fixed<formats::unit> q[2][2][3];
  RELIEVO_FIELDS(q)
};

struct table_request {
  bool read;
  hls::fixed<formats::map_size> x;
  hls::fixed<formats::map_size> y;
  RELIEVO_FIELDS(read, x, y)
};
struct table_word {
  hls::fixed<formats::table_sum> word;
  RELIEVO_FIELDS(word)
};

template <class Record, int N>
struct group {
  Record at[N];
  RELIEVO_FIELDS(at)
};

// The quads that profile_test asks for together, and which of them it wants: the others may lie anywhere.
template <int N>
struct wanted_quads {
  group<quad_request, N> quads;
  bool wanted[N];
  RELIEVO_FIELDS(quads, wanted)
};

}  // namespace relievo::tb
