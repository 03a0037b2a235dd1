// decision_bounds: how far golden's measure of a test may lie from the ideal one on the same two end records.
//
// h is half an LSB of `unit`, 2^-15 (a `direction` has the same LSB); r3 = sqrt(3), r2 = sqrt(2). A rounded vector moves by at
// most r3 h, and |a/|a| - b/|b|| <= 2 |a - b| / (|a| + |b|) for any two vectors. Per test:
//
//   vt   0: the records say all.
//   ct   U12 is the exact midpoint or half an LSB above it: the texel differs only where that reaches an integer.
//   sht  e, S1 and S2 follow from the records. A clipped rectangle is off by half a sample LSB per texel of its full area:
//        2^-5 (16 e_u e_v [middle] + 8 e_u e_v [end 1] + 8 e_u e_v [end 2]) <= e_u e_v. Where U12 is rounded up to an integer,
//        the middle moves by a texel: 4 e_v (or 4 e_u) texels enter, as many leave, each at most 65535.
//   pt   each sample is off by half a sample LSB and, inside, by what U lost in its register (at most 2^-12 per axis) on the
//        map's slope there (L per texel): n (2^-4 + |du| L_u + |dv| L_v).
//   nt   N' of the new vertex, see new_normal_bound; ends are records, and the largest of differences moves no more than they do.
//   ht   |N'| of the new vertex times |H|.
//
// The bounds hold where no register saturates. docs/error_budget.md repeats them; tests/core/error_budget.cpp measures.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "golden/core/rounding.hpp"
#include "golden/edge/profile_test.hpp"
#include "golden/edge/summed_height_test.hpp"
#include "golden/surface/map_address.hpp"
#include "golden/surface/normal_map.hpp"

namespace relievo {
namespace golden {

template <class F>
constexpr double half_lsb() {
  return range_of<F>::lsb / 2;
}

// Largest change of a/|a| when a, of the given length, moves by at most `change`.
inline double unit_change(double change, double length) {
  if (change == 0) return 0;
  return 2 * length <= change ? 2.0 : std::min(2.0, 2 * change / (2 * length - change));
}

namespace detail {

inline double size_of(double d) { return std::abs(d); }
inline double size_of(glm::dvec3 const& d) { return glm::length(d); }

}  // namespace detail

// Largest change of a bilinear memory between a coordinate before and after its register: |du| L_u + |dv| L_v, L the steepest
// changes per texel in the cells between the two. At most half an LSB of U times L_u + L_v, and nothing where U needed no rounding.
template <class Memory>
double change_by_rounding(glm::dvec2 const& u_exact, glm::dvec2 const& u_rounded, map_regs const& map, Memory const& memory) {
  const glm::dvec2 moved = glm::abs(u_exact - u_rounded);
  if (moved == glm::dvec2(0)) return 0;
  double along_u = 0, along_v = 0;
  for (const double x : {u_exact.x, u_rounded.x})
    for (const double y : {u_exact.y, u_rounded.y}) {
      const map_address_out at = map_address<exact>({{x, y}}, map);
      const auto m00 = memory(at.x[0], at.y[0]), m10 = memory(at.x[1], at.y[0]), m01 = memory(at.x[0], at.y[1]),
                 m11 = memory(at.x[1], at.y[1]);
      along_u = std::max({along_u, detail::size_of(m10 - m00), detail::size_of(m11 - m01)});
      along_v = std::max({along_v, detail::size_of(m01 - m00), detail::size_of(m11 - m10)});
    }
  return moved.x * along_u + moved.y * along_v;
}

// sht, at the same midpoint cell: see redecide for the edges whose midpoint the register moves to the next texel.
inline double summed_height_bound(glm::dvec2 const& u1, glm::dvec2 const& u2, glm::dvec2 const& u12, map_regs const& map) {
  const glm::ivec2 e = summed_height_extent(u1, u2, map);
  const auto sticks_out = [&](glm::dvec2 const& u, int times) {
    const auto axis = [times](double at, int extent, double size, bool wrap) {
      const int c = static_cast<int>(std::floor(at + 1));
      return !wrap && (c - times * extent < 0 || c + times * extent > static_cast<int>(size));
    };
    return axis(u.x, e.x, map.width, map.wrap_u) || axis(u.y, e.y, map.height, map.wrap_v);
  };
  const double area = 4.0 * e.x * e.y;
  double texels = 0;
  if (sticks_out(u12, 2)) texels += 4 * area;
  if (sticks_out(u1, 1)) texels += 2 * area;
  if (sticks_out(u2, 1)) texels += 2 * area;
  return half_lsb<formats::sample>() * texels;
}

// pt: bound of the largest a_j.
template <class Texels>
double profile_bound(profile_test_in const& in, map_regs const& map, Texels const& texels) {
  const int n = profile_intervals(in);
  double change = 0;
  for (int j = 1; j < n; ++j) {
    const double k = 16.0 * j / n;
    const glm::dvec2 u = calculate_new_u<exact>({in.u1, in.u2, k}).u, u_rounded = calculate_new_u<rounded>({in.u1, in.u2, k}).u;
    change = std::max(change, change_by_rounding(u, u_rounded, map, texels));
  }
  return n * (2 * half_lsb<formats::sample>() + change);
}

// The shortest direction behind the map's normals around a coordinate, before and after its register: its z is 2^-e.
template <class Normals>
double shortest_direction(glm::dvec2 const& u_exact, glm::dvec2 const& u_rounded, map_regs const& map, double normal_shift,
                          Normals const& normals) {
  double z = 0;
  for (const double x : {u_exact.x, u_rounded.x})
    for (const double y : {u_exact.y, u_rounded.y}) {
      const map_address_out at = map_address<exact>({{x, y}}, map);
      z = std::max({z, normals(at.x[0], at.y[0]).z, normals(at.x[1], at.y[0]).z, normals(at.x[0], at.y[1]).z, normals(at.x[1], at.y[1]).z});
    }
  return power_of_two(-static_cast<int>(normal_shift)) / z;
}

// What the bound of N' depends on, all of it ideal: the ends' N and T and the place k, the frame and the map's normal at the
// new vertex, how far that normal moves by the rounding of U, and the shortest direction it comes from.
struct new_normal_terms {
  glm::dvec3 n1, n2, t1, t2;
  double k;
  glm::dvec3 n, t, m;
  double normal_change;
  double shortest_direction;
};
struct new_normal_bound_out {
  double component;
  double length;
};

// N' = normalize(N m_z + T m_x + B m_y):
//   N, T   (n_1 (16-k) + n_2 k)/8 rounded (not at k = 8, which is a multiple of the LSB), normalised, rounded:  e_n, e_t
//   m      two components of each texel's direction rounded, normalised, rounded; the bilinear weights are convex;
//          what U lost, on the slope of the normals; rounded:  e_m
//   B      e_b = e_n + e_t + e_n e_t + r3 h
//   sum    sqrt(1 + |N.T|) e_m + e_n |m_z| + e_t |m_x| + e_b |m_y| + r3 h   (m within e_m of golden's)
//   N'     normalised, rounded
inline new_normal_bound_out new_normal_bound(new_normal_terms const& at) {
  const double h = half_lsb<formats::unit>(), r3 = std::sqrt(3.0), r2 = std::sqrt(2.0);
  static_assert(formats::unit::fraction == formats::direction::fraction, "one h for both");
  const double mean = at.k == 8 ? 0 : r3 * half_lsb<formats::direction>();
  const auto of_new = [&](glm::dvec3 const& a, glm::dvec3 const& b) {
    return unit_change(mean, glm::length((a * (16 - at.k) + b * at.k) / 8.0)) + r3 * h;
  };
  const double e_n = of_new(at.n1, at.n2), e_t = of_new(at.t1, at.t2);
  const double e_texel = unit_change(r2 * half_lsb<formats::direction>(), at.shortest_direction) + r3 * h;
  const double e_m = e_texel + at.normal_change + r3 * h;
  const double e_b = e_n + e_t + e_n * e_t + r3 * h;
  const glm::dvec3 m = glm::abs(at.m) + e_m;
  const double sum =
      std::sqrt(1 + std::abs(glm::dot(at.n, at.t))) * e_m + e_n * m.z + e_t * m.x + e_b * m.y + r3 * half_lsb<formats::direction>();
  const glm::dvec3 ideal_sum = at.n * at.m.z + at.t * at.m.x + glm::cross(at.n, at.t) * at.m.y;
  const double turned = unit_change(sum, glm::length(ideal_sum));
  return {std::min(2.0, turned + h), std::min(2.0, turned + r3 * h)};
}

}  // namespace golden
}  // namespace relievo
