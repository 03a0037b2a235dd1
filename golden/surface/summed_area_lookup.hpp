// summed_area_lookup: the sum S of the texels in a rectangle [x0, x1) x [y0, y1).         Doggett & Hirche 2000, eq. 2
//   S = SAT(x1, y1) - SAT(x0, y1) - SAT(x1, y0) + SAT(x0, y0), modulo 2^40
//
//   in   x0, y0, x1, y1       integers; the rectangle may stick out of the map. At most 2^24 texels, some of them inside,
//        and on a wrapped axis within six turns of the map (what the summed height test can ask reaches two texels beyond it)
//   out  s   rectangle_sum
//   memory   table(x, y) -> stored word, SAT(x+1, y+1)
//   registers: sample (the mean of a clipped rectangle)
//
// A wrapped axis repeats: SAT(x + W, y) = SAT(x, y) + SAT(W, y), any number of turns either way. On a clamped axis the
// rectangle is cut to the map, and what was cut away is taken to have the mean of the rest: s = mean * full area.
#pragma once
#include <algorithm>
#include <cstdint>

#include "golden/core/quotient.hpp"
#include "golden/core/rounding.hpp"
#include "golden/surface/map_regs.hpp"
#include "golden/surface/summed_area_table.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct summed_area_lookup_in {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  RELIEVO_FIELDS(x0, y0, x1, y1)
};
struct summed_area_lookup_out {
  double s = 0;
  RELIEVO_FIELDS(s)
};

namespace detail {

// SAT(x, y) of the endless map; a clamped axis never asks outside [0, W].
template <class Table>
std::uint64_t table_at(int x, int y, map_regs const& map, Table const& table) {
  const int w = static_cast<int>(map.width), h = static_cast<int>(map.height);
  const auto word = [&table](int i, int j) { return i > 0 && j > 0 ? table(i - 1, j - 1) : std::uint64_t{0}; };
  const auto turns_of = [](int i, int size) { return i >= 0 ? i / size : -((size - 1 - i) / size); };
  const int turns_x = map.wrap_u ? turns_of(x, w) : 0, turns_y = map.wrap_v ? turns_of(y, h) : 0;
  const int rest_x = x - turns_x * w, rest_y = y - turns_y * h;
  // Unsigned arithmetic wraps modulo 2^64, of which 2^40 is a divisor: negative turns need no case of their own.
  const auto tx = static_cast<std::uint64_t>(std::int64_t{turns_x}), ty = static_cast<std::uint64_t>(std::int64_t{turns_y});
  return tx * ty * word(w, h) + tx * word(w, rest_y) + ty * word(rest_x, h) + word(rest_x, rest_y);
}

}  // namespace detail

template <class Rounding, class Table>
summed_area_lookup_out summed_area_lookup(summed_area_lookup_in const& in, map_regs const& map, Table const& table) {
  static_assert(formats::area::width + formats::sample::width <= formats::rectangle_sum::width, "mean times area");
  summed_area_lookup_in inside = in;
  if (!map.wrap_u) {
    inside.x0 = std::max(in.x0, 0);
    inside.x1 = std::min(in.x1, static_cast<int>(map.width));
  }
  if (!map.wrap_v) {
    inside.y0 = std::max(in.y0, 0);
    inside.y1 = std::min(in.y1, static_cast<int>(map.height));
  }
  const auto at = [&](int x, int y) { return detail::table_at(x, y, map, table); };
  const std::uint64_t words = at(inside.x1, inside.y1) - at(inside.x0, inside.y1) - at(inside.x1, inside.y0) + at(inside.x0, inside.y0);
  const auto sum = static_cast<double>(words & table_mask);
  const auto area = [](summed_area_lookup_in const& r) { return static_cast<double>(r.x1 - r.x0) * static_cast<double>(r.y1 - r.y0); };
  if (area(inside) == area(in)) return {sum};
  bool clipped = false;
  return {quotient<Rounding, formats::sample, formats::area::width>(sum, area(inside), clipped) * area(in)};
}

}  // namespace golden
}  // namespace relievo
