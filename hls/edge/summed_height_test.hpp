// summed_height_test: does the height around the middle of an edge differ from that around its ends?
//   sht = |S(P12)/2 - (S(P1) + S(P2))| > shthr                Doggett & Hirche 2000, 2.3 and 3.1.3 (printed with < and no modulus)
//   in    u1, u2, u12  coordinate[2], texels; u12 is the midpoint
//   regs  map; average: compare means instead of sums; sum_threshold (sample x texel), average_threshold (sample); memory table
//   out   sht
//   Half extents per axis: e = max(1, round(|u1 - u2| / 8)) at the ends, on a wrapped axis at most max(1, W/4), and 2e in the middle,
//   so the areas are 4:1 and a constant height cancels. Texel i fills [i, i+1): the centre column of U is floor(U + 1).
//   Nothing is divided: sum mode |S12 - 2 (S1 + S2)| > 2 thr, average mode > 16 e_u e_v thr. Exact.
//   three summed_area_lookups, 12 table reads (up to 48 beyond wrapped borders); initiation interval reads / reads per clock
#pragma once
#include "hls/surface/summed_area_lookup.hpp"

namespace relievo {
namespace hls {

struct summed_height_test_in {
  fixed<formats::coordinate> u1[2];
  fixed<formats::coordinate> u2[2];
  fixed<formats::coordinate> u12[2];
  RELIEVO_FIELDS(u1, u2, u12)
};
struct summed_height_test_regs {
  bool average;
  fixed<formats::sum_threshold> sum_threshold;
  fixed<formats::average_threshold> average_threshold;
  RELIEVO_FIELDS(average, sum_threshold, average_threshold)
};
struct summed_height_test_out {
  bool sht;
  RELIEVO_FIELDS(sht)
};

namespace detail {
using half_extent = format<11, 11, false>;

inline fixed<half_extent> half_extent_of(fixed<formats::coordinate> u1, fixed<formats::coordinate> u2, fixed<formats::map_size> size,
                                         bool wrap) {
  const auto rounded = round_to<half_extent>(times_two_to<-3>(magnitude(u1 - u2)));
  const std::int64_t quarter = raw(size) >> 2;
  std::int64_t e = raw(rounded);
  if (wrap && e > quarter) e = quarter;
  return from_raw<half_extent>(e > 1 ? e : 1);
}

inline fixed<formats::rectangle_sum> sum_around(fixed<formats::coordinate> const (&u)[2], std::int64_t eu, std::int64_t ev,
                                                map_regs const& map, table_memory const& memory) {
  const std::int64_t column = floor_int(u[0]) + 1, row = floor_int(u[1]) + 1;
  const summed_area_lookup_in rectangle = {from_raw<formats::bound>(column - eu), from_raw<formats::bound>(row - ev),
                                           from_raw<formats::bound>(column + eu), from_raw<formats::bound>(row + ev)};
  return summed_area_lookup(rectangle, map, memory).s;
}
}  // namespace detail

inline summed_height_test_out summed_height_test(summed_height_test_in const& in, map_regs const& map, summed_height_test_regs const& regs,
                                                 table_memory const& memory) {
  const auto s0_eu = detail::half_extent_of(in.u1[0], in.u2[0], map.width, map.wrap_u);
  const auto s0_ev = detail::half_extent_of(in.u1[1], in.u2[1], map.height, map.wrap_v);
  const auto s1_first = detail::sum_around(in.u1, raw(s0_eu), raw(s0_ev), map, memory);
  const auto s1_second = detail::sum_around(in.u2, raw(s0_eu), raw(s0_ev), map, memory);
  const auto s1_middle = detail::sum_around(in.u12, 2 * raw(s0_eu), 2 * raw(s0_ev), map, memory);
  const auto s2_difference = magnitude(s1_middle - times_two_to<1>(s1_first + s1_second));
  summed_height_test_out out;
  out.sht = regs.average ? s2_difference > times_two_to<4>(s0_eu * s0_ev * regs.average_threshold)
                         : s2_difference > times_two_to<1>(regs.sum_threshold);
  return out;
}

}  // namespace hls
}  // namespace relievo
