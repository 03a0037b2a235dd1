// shapes: bring drawn words into what the host lets through, keeping the borders of the domain likely.
//
//   size_within(size, limit, g)       a map size 1..limit, small ones and the limit often
//   coordinate_within(u, size, wrap)  a texture coordinate inside the map: [0, W-1] clamped, [0, W] wrapped, both ends often
//   unit_vector(v, g)                 mostly normalised vectors, sometimes an axis, seldom left as it was drawn
//   near(b, a, span, g)               a word within span LSB of another
#pragma once
#include <cmath>

#include "hls/surface/map_regs.hpp"
#include "tests/support/random.hpp"

namespace relievo::test {

inline void size_within(hls::fixed<formats::map_size>& size, std::int64_t limit, generator& g) {
  const std::uint64_t kind = g.below(4);
  const std::int64_t drawn = kind == 0 ? 1 + raw(size) % limit : kind == 1 ? limit : g.between(1, limit < 4 ? limit : 4);
  size = hls::from_raw<formats::map_size>(drawn);
}

inline std::int64_t coordinate_limit(hls::fixed<formats::map_size> size, bool wrap) {
  return (raw(size) - (wrap ? 0 : 1)) * (std::int64_t(1) << formats::coordinate::fraction);
}

inline void coordinate_within(hls::fixed<formats::coordinate>& u, hls::fixed<formats::map_size> size, bool wrap, generator& g) {
  const std::int64_t limit = coordinate_limit(size, wrap);
  std::int64_t word = raw(u);
  if (word > limit) {
    const std::uint64_t kind = g.below(8);
    word = kind == 0 || limit == 0 ? limit : kind == 1 ? limit - 1 : word % (limit + 1);
  }
  u = hls::from_raw<formats::coordinate>(word);
}

inline void coordinates_within(hls::fixed<formats::coordinate> (&u)[2], hls::map_regs const& map, generator& g) {
  coordinate_within(u[0], map.width, map.wrap_u, g);
  coordinate_within(u[1], map.height, map.wrap_v, g);
}

inline void unit_vector(hls::fixed<formats::unit> (&v)[3], generator& g) {
  const std::uint64_t kind = g.below(16);
  if (kind == 0) return;
  if (kind == 1) {
    const std::uint64_t axis = g.below(3);
    for (std::uint64_t i = 0; i < 3; ++i) v[i] = hls::from_raw<formats::unit>(i == axis ? (g.chance(2) ? 16384 : -16384) : 0);
    return;
  }
  double length = 0;
  double x[3];
  for (int i = 0; i < 3; ++i) {
    x[i] = static_cast<double>(raw(v[i]));
    length += x[i] * x[i];
  }
  if (length == 0) return;
  for (int i = 0; i < 3; ++i) v[i] = hls::from_raw<formats::unit>(std::lround(x[i] / std::sqrt(length) * 16384));
}

template <class F>
void near(hls::fixed<F>& b, hls::fixed<F> a, std::int64_t span, generator& g) {
  std::int64_t word = raw(a) + g.between(-span, span);
  if (word > hls::fixed<F>::max_raw) word = hls::fixed<F>::max_raw;
  if (word < hls::fixed<F>::min_raw) word = hls::fixed<F>::min_raw;
  b = hls::from_raw<F>(word);
}

}  // namespace relievo::test
