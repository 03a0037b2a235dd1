// map_address: the 2 x 2 texels around a texture coordinate, and the weights between them.
//   in    u     coordinate[2], in texels; texel i is a sample at the integer i
//   regs  map   sizes; per axis clamp or wrap
//   out   x[2], y[2]  columns and rows of the quad, each within the map
//         f     fractions of u and v (11 bits)
//   clamp: x0 = min(floor u, W-1), x1 = min(x0+1, W-1);  wrap: x0 = floor u mod W, x1 = (x0+1) mod W.
//   The host refuses coordinates beyond W-1 (clamped) or W (wrapped), so one subtraction is the modulo.
//   initiation interval 1
#pragma once
#include "hls/surface/map_regs.hpp"

namespace relievo {
namespace hls {

static_assert(formats::fraction::width == formats::coordinate::fraction, "the fraction of a coordinate");

struct map_address_in {
  fixed<formats::coordinate> u[2];
  RELIEVO_FIELDS(u)
};
struct map_address_out {
  fixed<formats::map_size> x[2];
  fixed<formats::map_size> y[2];
  fixed<formats::fraction> f[2];
  RELIEVO_FIELDS(x, y, f)
};

inline map_address_out map_address(map_address_in const& in, map_regs const& map) {
  map_address_out out;
  for (int axis = 0; axis < 2; ++axis) {
    const std::int64_t size = raw(axis == 0 ? map.width : map.height);
    const bool wrap = axis == 0 ? map.wrap_u : map.wrap_v;
    const std::int64_t whole = floor_int(in.u[axis]);
    const std::int64_t low = whole < size ? whole : wrap ? whole - size : size - 1;
    const std::int64_t high = low + 1 < size ? low + 1 : wrap ? 0 : size - 1;
    fixed<formats::map_size>(&cell)[2] = axis == 0 ? out.x : out.y;
    cell[0] = from_raw<formats::map_size>(low);
    cell[1] = from_raw<formats::map_size>(high);
    out.f[axis] = wrap_to<formats::fraction>(in.u[axis]);
  }
  return out;
}

// Word index of a texel in a memory; 26 bits.
inline std::uint32_t word_index(fixed<formats::map_size> x, fixed<formats::map_size> y, map_regs const& map) {
  return static_cast<std::uint32_t>(raw(y) * raw(map.width) + raw(x));
}

// The bilinear sum of a quad q[row][column], exact: 22 fractional bits more than the texels.
template <class F>
inline auto bilinear(fixed<F> const (&q)[2][2], fixed<formats::fraction> const (&f)[2]) {
  using weight = format<formats::fraction::width + 1, 1, false>;
  const auto one = from_raw<weight>(std::int64_t(1) << formats::fraction::width);
  const auto fx = exact_to<weight>(f[0]);
  const auto gx = wrap_to<weight>(one - fx);
  const auto fy = exact_to<weight>(f[1]);
  const auto gy = wrap_to<weight>(one - fy);
  const auto s0_bottom = q[0][0] * gx + q[0][1] * fx;
  const auto s0_top = q[1][0] * gx + q[1][1] * fx;
  return s0_bottom * gy + s0_top * fy;
}

}  // namespace hls
}  // namespace relievo
