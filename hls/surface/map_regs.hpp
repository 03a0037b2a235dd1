// map_regs: size of the maps and what happens beyond their borders, constant while a scene runs.
//   width, height  map_size, 1..8192 texels
//   wrap_u, wrap_v an axis that wraps, else it clamps
// Memories: read-only words, one per texel, row by row from v = 0, x fastest.
//   texel_memory   16-bit displacement
//   table_memory   word (x, y) is the exclusive summed-area table's SAT(x+1, y+1) modulo 2^40
//   normal_memory  three units packed from bit 0: x, y, z (48 bits)
#pragma once
#include "hls/core/fixed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace hls {

struct map_regs {
  fixed<formats::map_size> width;
  fixed<formats::map_size> height;
  bool wrap_u;
  bool wrap_v;
  RELIEVO_FIELDS(width, height, wrap_u, wrap_v)
};

struct texel_memory {
  std::uint16_t const* words;
};
struct table_memory {
  std::uint64_t const* words;
};
struct normal_memory {
  std::uint64_t const* words;
};

inline std::uint64_t pack_normal(fixed<formats::unit> const (&n)[3]) {
  return (static_cast<std::uint64_t>(raw(n[0])) & 0xffff) | ((static_cast<std::uint64_t>(raw(n[1])) & 0xffff) << 16) |
         ((static_cast<std::uint64_t>(raw(n[2])) & 0xffff) << 32);
}
inline fixed<formats::unit> unpack_normal(std::uint64_t word, int component) {
  return from_raw<formats::unit>(static_cast<std::int16_t>((word >> (16 * component)) & 0xffff));
}

}  // namespace hls
}  // namespace relievo
