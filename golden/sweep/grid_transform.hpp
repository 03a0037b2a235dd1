// grid_transform: a position on the screen and its depth, to the voxel grid.       Gumhold & Huettner 1999, section 3.1, Figure 8, (4)
//   x, y = screen / g;  z = ln(w / near) / ln(1 + 2 g tan(alpha/2) / H) = kappa ln(w / near), g the size of a cell in pixels
//
//   in    screen   screen     from transform;  w  depth, > 0
//   regs  cells_per_pixel     cells         1/g
//         octave   depth_cells   kappa ln 2, the table's last word
//         near_cells  depth_cells   depth_cells_of(near), so that z is 0 there
//   memory  table[i], i = 0..256   depth_cells   kappa ln(1 + i/256), from z_table
//   out   p        grid       saturated: a component beyond [-32767, 32767], which is its end there
//   registers: grid
//
// The paper's table is one over z. Here w = 2^e (1 + (i + f) / 256) LSB, i = 0..255 and f in [0, 1), so that one octave is enough:
//   z = e octave + T[i] + f (T[i+1] - T[i]) - near_cells
// The sum has 33 fractional bits and does not fit a double; int64 holds it for any words: (27 + 1 + 1) 2^39 2^19 < 2^63.
//
// Error of z against (4), in cells, with E = |e(w) - e(near)|:                       docs/error_budget.md, "The grid in z"
//   1/2 + kappa 2^-19 (the chords of the table) + kappa (E + 2) 2^-31 + (E + 3 + ln(w / near)) 2^-15
#pragma once
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "golden/sweep/world_data.hpp"

namespace relievo {
namespace golden {

namespace detail {

// A place on the axis of w: 2^e (1 + (i + f) / 256) LSB of depth.
struct octave_place {
  int e = 0, i = 0;
  double f = 0;
};
inline octave_place place_in_octave(double w) {
  octave_place at;
  const double mantissa = 2 * std::frexp(w * power_of_two(formats::depth::fraction), &at.e);
  --at.e;
  const double place = (mantissa - 1) * 256;
  at.i = static_cast<int>(place);
  at.f = place - at.i;
  return at;
}

// What is behind the LSB of depth_cells in f (T[i+1] - T[i]): f has the bits of w below its leading nine.
constexpr int f_bits = formats::depth::width - 9;

inline std::int64_t depth_cells_word(double z) { return static_cast<std::int64_t>(z * power_of_two(formats::depth_cells::fraction)); }

// e octave + T[i] + f (T[i+1] - T[i]) - start, rounded half up to F: exact before that.
template <class Rounding, class F, class Table>
double cells_beyond(double w, double octave, Table const& table, double start) {
  const octave_place at = place_in_octave(w);
  const auto i = static_cast<std::size_t>(at.i);
  if constexpr (Rounding::is_exact) {
    return at.e * octave + table[i] + at.f * (table[i + 1] - table[i]) - start;
  } else {
    static_assert(formats::depth::width + 1 <= 1 << (63 - f_bits - (formats::depth_cells::width - 1)), "the sum fits int64");
    const std::int64_t whole = at.e * depth_cells_word(octave) + depth_cells_word(table[i]) - depth_cells_word(start);
    const std::int64_t part = static_cast<std::int64_t>(at.f * power_of_two(f_bits)) * depth_cells_word(table[i + 1] - table[i]);
    const std::int64_t sum = whole * (std::int64_t{1} << f_bits) + part;
    constexpr std::int64_t lsb = std::int64_t{1} << (f_bits + formats::depth_cells::fraction - F::fraction);
    // floor((sum + lsb / 2) / lsb)
    const std::int64_t moved = sum + lsb / 2, floored = moved / lsb - (moved % lsb < 0 ? 1 : 0);
    return static_cast<double>(floored) * range_of<F>::lsb;
  }
}

}  // namespace detail

// z before near_cells is taken off: what `near_cells` is of `near`.
template <class Rounding = rounded, class Table>
double depth_cells_of(double w, double octave, Table const& table) {
  return Rounding::template at<formats::depth_cells>(detail::cells_beyond<Rounding, formats::depth_cells>(w, octave, table, 0));
}

template <class Rounding = rounded, class Table>
grid_transform_out grid_transform(grid_transform_in const& in, grid_transform_regs const& regs, Table const& table) {
  using namespace formats;
  static_assert(fits_double(bits_of<screen>() * bits_of<cells>()), "x and y");
  grid_transform_out out;
  const glm::dvec3 p{in.screen * regs.cells_per_pixel, detail::cells_beyond<Rounding, grid>(in.w, regs.octave, table, regs.near_cells)};
  constexpr double most = range_of<grid>::max;
  for (int i = 0; i < 3; ++i) {
    out.p[i] = Rounding::is_exact ? p[i] : glm::clamp(round_half_up(p[i]), -most, most);
    out.saturated |= !Rounding::is_exact && out.p[i] != round_half_up(p[i]);
  }
  return out;
}

}  // namespace golden
}  // namespace relievo
