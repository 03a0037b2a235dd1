// grid_transform: a screen position and its depth to the voxel grid, whose cells are about cubes.
//   x, y = screen / g;  z = ln(w / near) / ln(1 + 2 g tan(alpha/2) / H)            Gumhold & Huettner 1999, 3.1, Figure 8, equation (4)
//   in    screen    screen[2], w depth: transform's, w > 0
//   regs  cells_per_pixel 1/g, octave kappa ln 2, near_cells depth_cells_of(near);  memory z: z_table's T, 257 words, two read a vertex
//   out   p         grid[3]
//         saturated a position beyond [-32767, 32767], which is held at its end
//   w = 2^e (1 + (i + f)/256) in LSB: e its leading bit, i the 8 bits below, f the rest. The paper's array over z becomes one over an
//   octave:
//     z = e octave + T[i] + f (T[i+1] - T[i]) - near_cells, exact, rounded once
//   Never falls as w rises, as T does not and T[256] is `octave`. Against (4): docs/error_budget.md, "The grid in z".
//   registers: p; four products; initiation interval 1
#pragma once
#include "hls/sweep/perspective_preparation.hpp"
#include "hls/sweep/world_data.hpp"

namespace relievo {
namespace hls {

namespace detail {

// Cells from w = 1 LSB on: `whole` has the fraction of depth_cells; `between` is f (T[i+1] - T[i]).
struct cells_of_depth {
  fixed<format<46, 32, true>> whole;
  fixed<format<60, 27, true>> between;
};

inline cells_of_depth place_in_octave(fixed<formats::depth> w, fixed<formats::depth_cells> octave, z_memory const& z) {
  constexpr int index_bits = 8, top = formats::depth::width - 1, rest = top - index_bits;
  static_assert(z_table_words == (1 << index_bits) + 1, "the table holds an octave and its end");
  const int e = leading_bit(w);
  // Below the leading bit, from the top: i, then f.
  const std::int64_t below = (raw(w) << (top - e)) & ((std::int64_t(1) << top) - 1);
  const std::int64_t i = below >> rest;
  const auto f = from_raw<format<rest, 0, false>>(below & ((std::int64_t(1) << rest) - 1));
  const auto s0_low = from_raw<formats::depth_cells>(z.words[i]);
  const auto s0_high = from_raw<formats::depth_cells>(z.words[i + 1]);
  cells_of_depth cells;
  cells.whole = from_raw<format<5, 5, false>>(e) * octave + s0_low;
  cells.between = f * (s0_high - s0_low);
  static_assert(decltype(cells.between)::format_type::width <= 64 && decltype(cells.whole)::format_type::width <= 53,
                "the sum to its last bit would need 65 bits: hence the two parts");
  return cells;
}

// -32768 has no mirror image and is no position.
template <class From>
inline fixed<formats::grid> grid_position(fixed<From> x, bool& saturated) {
  const fixed<formats::grid> rounded = round_to<formats::grid>(x, saturated);
  if (raw(rounded) != fixed<formats::grid>::min_raw) return rounded;
  saturated = true;
  return from_raw<formats::grid>(fixed<formats::grid>::min_raw + 1);
}

}  // namespace detail

// z before near_cells is taken off, at any depth: the register near_cells is that of `near`.
inline fixed<formats::depth_cells> depth_cells_of(fixed<formats::depth> w, fixed<formats::depth_cells> octave, z_memory const& z) {
  const detail::cells_of_depth cells = detail::place_in_octave(w, octave, z);
  // A multiple of the LSB moves no rounding.
  return round_to<formats::depth_cells>(cells.whole + round_to<format<42, 28, true>>(cells.between));
}

inline grid_transform_out grid_transform(grid_transform_in const& in, grid_transform_regs const& regs, z_memory const& z) {
  grid_transform_out out;
  out.saturated = false;
  for (int axis = 0; axis < 2; ++axis) out.p[axis] = detail::grid_position(in.screen[axis] * regs.cells_per_pixel, out.saturated);
  const detail::cells_of_depth cells = detail::place_in_octave(in.w, regs.octave, z);
  // Cut to the fraction of all the rest, which a cell's half has too: whether the sum reaches the half stays the same.
  const auto between = floor_to<format<41, 27, true>>(cells.between);
  out.p[2] = detail::grid_position(cells.whole + between - regs.near_cells, out.saturated);
  return out;
}

}  // namespace hls
}  // namespace relievo
