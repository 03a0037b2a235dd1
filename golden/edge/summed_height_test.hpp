// summed_height_test: does the mean height change along the edge?
//   sht = |S(P_12)/2 - (S(P_1) + S(P_2))| > shthr                                  Doggett & Hirche 2000, section 2.3, 3.1.3
//
//   in    u1, u2, u12   coordinate   ends and midpoint (k = 8)
//   regs  map_regs; average: compare means instead of sums
//         sum_threshold       sum_threshold       sample x texel
//         average_threshold   average_threshold   sample
//   out   sht                  exact, arranged so that nothing is divided:
//           sum:      |S12 - 2 (S1 + S2)| > 2 sum_threshold
//           average:  |S12 - 2 (S1 + S2)| > 16 e_u e_v average_threshold     (|mean of the middle - mean of both ends|)
//   memory   table(x, y), see summed_area_lookup;  registers: those of summed_area_lookup
//
// Rectangles: per axis d = |u1 - u2| and e = max(1, round half up(d / 8)), on a wrapped axis at most max(1, floor(W / 4)).
// Around the centre c = floor(U + 1), in the exclusive table where texel i is the cell [i, i+1): [c - e, c + e) at the ends,
// [c - 2e, c + 2e) at the midpoint. The areas are 4 : 1, so a constant height cancels exactly.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "golden/surface/map_regs.hpp"
#include "golden/surface/summed_area_lookup.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct summed_height_test_in {
  glm::dvec2 u1{0}, u2{0}, u12{0};
  RELIEVO_FIELDS(u1, u2, u12)
};
struct summed_height_test_regs {
  bool average = false;
  double sum_threshold = 0;
  double average_threshold = 0;
  RELIEVO_FIELDS(average, sum_threshold, average_threshold)
};
struct summed_height_test_out {
  bool sht = false;
  RELIEVO_FIELDS(sht)
};

// The two sides of the comparison, and the magnitude of what was summed.
struct summed_height_sides {
  double measure;
  double threshold;
  double scale;
};

// Half-extents of the rectangles at the ends.
inline glm::ivec2 summed_height_extent(glm::dvec2 const& u1, glm::dvec2 const& u2, map_regs const& map) {
  const auto axis = [](double d, double size, bool wrap) {
    const int e = std::max(1, static_cast<int>(std::floor(d / 8 + 0.5)));
    return wrap ? std::min(e, std::max(1, static_cast<int>(size) / 4)) : e;
  };
  const glm::dvec2 d = glm::abs(u1 - u2);
  return {axis(d.x, map.width, map.wrap_u), axis(d.y, map.height, map.wrap_v)};
}

template <class Rounding, class Table>
summed_height_sides summed_height_measure(summed_height_test_in const& in, map_regs const& map, summed_height_test_regs const& regs,
                                          Table const& table) {
  constexpr bits four_rectangles{formats::rectangle_sum::integer_bits + 4, formats::rectangle_sum::fraction};
  static_assert(fits_double(four_rectangles), "S12 - 2 (S1 + S2)");
  static_assert(fits_double(bits_of<formats::average_threshold>() * bits{29, 0}), "16 e_u e_v threshold");
  const glm::ivec2 e = summed_height_extent(in.u1, in.u2, map);
  const auto sum = [&](glm::dvec2 const& u, int times) {
    const glm::ivec2 c(glm::floor(u + 1.0));
    return summed_area_lookup<Rounding>({c.x - times * e.x, c.y - times * e.y, c.x + times * e.x, c.y + times * e.y}, map, table).s;
  };
  const double s1 = sum(in.u1, 1), s2 = sum(in.u2, 1), s12 = sum(in.u12, 2);
  const double threshold = regs.average ? 16.0 * e.x * e.y * regs.average_threshold : 2 * regs.sum_threshold;
  return {std::abs(s12 - 2 * (s1 + s2)), threshold, s12 + 2 * (s1 + s2)};
}

template <class Rounding, class Table>
summed_height_test_out summed_height_test(summed_height_test_in const& in, map_regs const& map, summed_height_test_regs const& regs,
                                          Table const& table) {
  const summed_height_sides sides = summed_height_measure<Rounding>(in, map, regs, table);
  return {Rounding::exceeds(sides.measure, sides.threshold, sides.scale)};
}

}  // namespace golden
}  // namespace relievo
