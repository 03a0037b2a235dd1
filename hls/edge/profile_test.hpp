// profile_test: how far does the map leave the chord of an edge, and where is the best place for a new vertex?
//   Douglas-Peucker on an edge; not in the paper. With D_j the sample at j/n and e_j = |D_j - ((n-j) D_0 + j D_n)/n|:
//   pt = max e_j > pthr,  k/16 = the j/n that maximises e_j j (n - j) in the middle third
//   in    u1, u2   coordinate[2], texels
//         forward  vertex 1 precedes vertex 2 by value
//   regs  map;  threshold  profile_threshold, samples;  memory displacement
//   out   pt
//         k        weight, sixteenths from vertex 1; 8 (the middle) when there is nothing to choose
//   d = larger extent in texels; d < 1.5: pt false, k = 8; n = smallest power of two >= d, 2 at least and at most profile_intervals_max
//   (build parameter, 16). Samples are taken at the coordinates that a vertex put there would have (calculate_new_u), so e_j is that
//   vertex's own error (a sample at the unrounded place would be that of a point where no vertex can stand). Ties go to the middle, then to
//   the end that precedes. Everything is scaled by n and exact. n + 1 quad reads; initiation interval (n + 1) / quads per clock
#pragma once
#include "hls/edge/calculate_new_u.hpp"
#include "hls/surface/map_sampler.hpp"

namespace relievo {
namespace hls {

struct profile_test_in {
  fixed<formats::coordinate> u1[2];
  fixed<formats::coordinate> u2[2];
  bool forward;
  RELIEVO_FIELDS(u1, u2, forward)
};
struct profile_test_regs {
  fixed<formats::profile_threshold> threshold;
  RELIEVO_FIELDS(threshold)
};
struct profile_test_out {
  bool pt;
  fixed<formats::weight> k;
  RELIEVO_FIELDS(pt, k)
};

namespace detail {

// log2 of the number of intervals, 0 where the edge is shorter than 1.5 texels.
inline int profile_levels(fixed<formats::coordinate> const (&u1)[2], fixed<formats::coordinate> const (&u2)[2]) {
  const auto du = magnitude(u1[0] - u2[0]);
  const auto dv = magnitude(u1[1] - u2[1]);
  const auto d = du > dv ? du : dv;
  const std::int64_t texel = std::int64_t(1) << formats::coordinate::fraction;
  if (2 * raw(d) < 3 * texel) return 0;
  int levels = 1;
  for (int l = 1; (2 << l) <= profile_intervals_max; ++l)
    if (raw(d) > (texel << l)) levels = l + 1;
  return levels;
}

}  // namespace detail

inline profile_test_out profile_test(profile_test_in const& in, map_regs const& map, profile_test_regs const& regs,
                                     texel_memory const& memory) {
  using count = format<5, 5, false>;
  profile_test_out out = {false, from_raw<formats::weight>(8)};
  const int levels = detail::profile_levels(in.u1, in.u2);
  if (levels == 0) return out;
  const int n = 1 << levels;
  const auto intervals = from_raw<count>(n);
  const auto s0_first = map_sampler({{in.u1[0], in.u1[1]}}, map, memory).d;
  const auto s0_last = map_sampler({{in.u2[0], in.u2[1]}}, map, memory).d;

  std::int64_t best = -1;
  int best_off_middle = 0;
  for (int j = 1; j < profile_intervals_max; ++j) {
    if (j >= n) continue;
    const auto place = from_raw<formats::weight>(j << (4 - levels));
    const calculate_new_u_out at = calculate_new_u({{in.u1[0], in.u1[1]}, {in.u2[0], in.u2[1]}, place});
    const auto s0_sample = map_sampler({{at.u[0], at.u[1]}}, map, memory).d;
    const auto s1_chord = s0_first * from_raw<count>(n - j) + s0_last * from_raw<count>(j);
    const auto s1_error = magnitude(s0_sample * intervals - s1_chord);
    out.pt |= s1_error > regs.threshold * intervals;

    if (3 * j < n || 3 * (n - j) < n) continue;
    const std::int64_t s2_gain = raw(s1_error) * (j * (n - j));
    const int off_middle = 2 * j > n ? 2 * j - n : n - 2 * j;
    const bool closer = off_middle < best_off_middle;
    // Of j and n - j, equal in all else, the smaller comes first here; it stays when the edge runs forward.
    const bool mirrored = off_middle == best_off_middle && !in.forward;
    if (s2_gain > best || (s2_gain == best && (closer || mirrored))) {
      best = s2_gain;
      best_off_middle = off_middle;
      out.k = place;
    }
  }
  return out;
}

}  // namespace hls
}  // namespace relievo
