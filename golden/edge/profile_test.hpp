// profile_test: how far does the map leave the chord of the edge, and where is a new vertex worth most?
//   e_j = |D(j/n) - ((n - j) D_0 + j D_n) / n|, pt = max e_j > pthr        beyond the paper: Douglas-Peucker on an edge
//
//   in    u1, u2     coordinate         forward: vertex 1 precedes vertex 2 (order by value, see vertex)
//   regs  map_regs;  threshold   profile_threshold   sample
//   out   pt                            exact on the sampler's output register: a_j = n e_j against n threshold
//         k          weight             place of the new vertex in sixteenths
//   memory   texels(x, y);  registers: coordinate (the sampled points), sample
//
// With d the larger extent in texels: d < 1.5 has no profile (pt false, k = 8); n is the smallest power of two >= d, within
// 2..16. k is where e_j j (n - j) is largest in the middle third (3j >= n, 3(n-j) >= n); ties go to the middle, then towards
// the end that comes first by value.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "golden/edge/calculate_new_u.hpp"
#include "golden/surface/map_regs.hpp"
#include "golden/surface/map_sampler.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct profile_test_in {
  glm::dvec2 u1{0}, u2{0};
  bool forward = false;
  RELIEVO_FIELDS(u1, u2, forward)
};
struct profile_test_regs {
  double threshold = 0;
  RELIEVO_FIELDS(threshold)
};
struct profile_test_out {
  bool pt = false;
  double k = 8;
  RELIEVO_FIELDS(pt, k)
};

// n, or 0 for an edge too short to have a profile.
inline int profile_intervals(profile_test_in const& in) {
  const glm::dvec2 extent = glm::abs(in.u1 - in.u2);
  const double d = std::max(extent.x, extent.y);
  if (d < 1.5) return 0;
  int n = 2;
  while (n < d && n < profile_intervals_max) n *= 2;
  return n;
}

// a_j = |n D_j - ((n - j) D_0 + j D_n)| for 0 < j < n. Grouped so that exchanging the ends gives the same bits in double.
struct profile_deviations {
  int n = 0;
  std::array<double, profile_intervals_max + 1> a{};
  double measure() const { return *std::max_element(a.begin(), a.end()); }
  // Samples reach 2^16; the coordinates' own noise in the ideal model is some 2^-40 texels, on slopes of up to 2^16.
  double scale() const { return n * power_of_two(20); }
};

template <class Rounding, class Texels>
profile_deviations profile_of(profile_test_in const& in, map_regs const& map, Texels const& texels) {
  static_assert(fits_double(bits_of<formats::sample>() * bits{14, 0}), "a_j j (n - j)");
  profile_deviations out;
  out.n = profile_intervals(in);
  if (out.n == 0) return out;
  std::array<double, profile_intervals_max + 1> d{};
  for (int j = 0; j <= out.n; ++j) {
    const glm::dvec2 u = calculate_new_u<Rounding>({in.u1, in.u2, 16.0 * j / out.n}).u;
    d[static_cast<std::size_t>(j)] = map_sampler<Rounding>({u}, map, texels).d;
  }
  const double first = d[0], last = d[static_cast<std::size_t>(out.n)];
  for (int j = 1; j < out.n; ++j) {
    const auto i = static_cast<std::size_t>(j);
    out.a[i] = std::abs(out.n * d[i] - ((out.n - j) * first + j * last));
  }
  return out;
}

// The place of the new vertex in sixteenths.
template <class Rounding>
int profile_place(profile_deviations const& profile, bool forward) {
  const int n = profile.n;
  if (n == 0) return 8;
  const auto worth = [&profile, n](int j) { return profile.a[static_cast<std::size_t>(j)] * (j * (n - j)); };
  const auto allowed = [n](int j) { return 3 * j >= n && 3 * (n - j) >= n; };
  double most = 0;
  for (int j = 1; j < n; ++j)
    if (allowed(j)) most = std::max(most, worth(j));
  const double least = most - Rounding::noise(profile.scale() * n * n / 4);
  int best = 0;
  for (int j = 1; j < n; ++j) {
    if (!allowed(j) || worth(j) < least) continue;
    const int nearer = best == 0 ? -1 : std::abs(2 * j - n) - std::abs(2 * best - n);
    if (nearer < 0 || (nearer == 0 && !forward)) best = j;
  }
  return 16 * best / n;
}

template <class Rounding, class Texels>
profile_test_out profile_test(profile_test_in const& in, map_regs const& map, profile_test_regs const& regs, Texels const& texels) {
  const profile_deviations profile = profile_of<Rounding>(in, map, texels);
  if (profile.n == 0) return {};
  return {Rounding::exceeds(profile.measure(), profile.n * regs.threshold, profile.scale()),
          static_cast<double>(profile_place<Rounding>(profile, in.forward))};
}

}  // namespace golden
}  // namespace relievo
