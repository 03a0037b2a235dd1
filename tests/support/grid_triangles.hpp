// grid_triangles: triangles with integer corners, drawn or counted through.
//
//   pair_of(number, r)          triangle `number` of the (2r + 1)^6 with p0 = 0 and p1, p2 in [-r, r]^3: all up to translation
//   three_main_directions(p)    each edge has another
//   draw_triangle(g, size)      corners in [0, size]^3, moved anywhere within the format now and then
//   draw_sliver(g, size)        a long edge and a third corner close to it; length up to size
//   in_all_poses(p, call)       the 6 orders of the corners x the 6 orders of the axes x the 8 mirror images
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "tests/support/random.hpp"

namespace relievo::test {

using grid_point = std::array<int, 3>;
using grid_triangle = std::array<grid_point, 3>;

inline std::string text_of(grid_triangle const& p) {
  std::string text;
  for (grid_point const& c : p) text += "(" + std::to_string(c[0]) + "," + std::to_string(c[1]) + "," + std::to_string(c[2]) + ")";
  return text;
}

constexpr std::uint64_t pairs_within(int r) {
  const std::uint64_t side = static_cast<std::uint64_t>(2 * r + 1);
  return side * side * side * side * side * side;
}
inline grid_triangle pair_of(std::uint64_t number, int r) {
  const std::uint64_t side = static_cast<std::uint64_t>(2 * r + 1);
  grid_triangle p{};
  for (std::size_t corner = 1; corner < 3; ++corner)
    for (int& x : p[corner]) {
      x = static_cast<int>(number % side) - r;
      number /= side;
    }
  return p;
}

inline std::size_t main_axis(grid_point const& from, grid_point const& to) {
  std::size_t main = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (std::abs(to[axis] - from[axis]) > std::abs(to[main] - from[main])) main = axis;
  return main;
}
inline bool three_main_directions(grid_triangle const& p) {
  return (1u << main_axis(p[0], p[1]) | 1u << main_axis(p[1], p[2]) | 1u << main_axis(p[2], p[0])) == 7;
}

inline void move(grid_triangle& p, grid_point const& by) {
  for (grid_point& corner : p)
    for (std::size_t axis = 0; axis < 3; ++axis) corner[axis] += by[axis];
}
inline grid_triangle draw_triangle(generator& g, int size) {
  grid_triangle p{};
  for (grid_point& corner : p)
    for (int& x : corner) x = static_cast<int>(g.between(0, size));
  const auto anywhere = [&] { return static_cast<int>(g.between(-32767, 32767 - size)); };
  if (g.chance(2)) move(p, {anywhere(), anywhere(), anywhere()});
  return p;
}
inline grid_triangle draw_sliver(generator& g, int size) {
  grid_triangle p{};
  for (int& x : p[1]) x = static_cast<int>(g.between(-size, size));
  const std::int64_t place = g.between(0, 64), off = g.chance(3) ? 3 : 1;
  for (std::size_t axis = 0; axis < 3; ++axis) p[2][axis] = static_cast<int>(p[1][axis] * place / 64 + g.between(-off, off));
  std::rotate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(g.below(3)), p.end());
  if (g.chance(2)) std::swap(p[0], p[1]);
  return p;
}

template <class Call>
void in_all_poses(grid_triangle const& p, Call call) {
  std::array<std::size_t, 3> corner = {0, 1, 2};
  do {
    std::array<std::size_t, 3> axis = {0, 1, 2};
    do {
      for (unsigned mirror = 0; mirror < 8; ++mirror) {
        grid_triangle pose{};
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t k = 0; k < 3; ++k) pose[i][k] = (mirror >> k & 1) != 0 ? -p[corner[i]][axis[k]] : p[corner[i]][axis[k]];
        call(pose);
      }
    } while (std::next_permutation(axis.begin(), axis.end()));
  } while (std::next_permutation(corner.begin(), corner.end()));
}

}  // namespace relievo::test
