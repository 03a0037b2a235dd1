// world_errors: the rows of docs/error_budget.md of the units between the world and the grid. The largest error of one random vector,
// golden against ideal given the same words, in LSB of the register; tests/core/error_budget.cpp holds them against the bounds.
//
//   world_measurements()   "unit register" -> the measurement
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "golden/sweep/base_triangle_clip.hpp"
#include "golden/sweep/grid_transform.hpp"
#include "golden/sweep/near_clip.hpp"
#include "golden/sweep/z_table.hpp"
#include "tests/support/swept_vertices.hpp"

namespace relievo::test {

namespace detail {

inline double grid_error(draw& d) {
  using namespace golden;
  static const std::vector<double> table = z_table_of(1234.5);
  const grid_transform_regs regs{d.word<formats::cells>(0, 1), table[256], depth_cells_of(1, table[256], table)};
  const grid_transform_in in{{d.word<formats::screen>(-8000, 8000), d.word<formats::screen>(-8000, 8000)},
                             d.word<formats::depth>(0.01, d.coin() ? 1 : 250)};
  const glm::dvec3 off = glm::abs(grid_transform<rounded>(in, regs, table).p - grid_transform<exact>(in, regs, table).p);
  return std::max({off.x, off.y, off.z});
}

inline double table_error(draw& d) {
  using namespace golden;
  const z_table_in in{rounded::at<formats::kappa>(d.coin() ? d.real(9e4, 93800) : d.real(0, 93800)), d.integer(0, 256)};
  return std::abs(z_table<rounded>(in).z - z_table<exact>(in).z) / range_of<formats::depth_cells>::lsb;
}

// An edge through the near plane, at least one unit deep and no component of it longer than it is deep.
template <class F, class Pick>
double cut_error(draw& d, Pick pick) {
  using namespace golden;
  near_clip_regs regs;
  const glm::dvec3 forward = d.direction();
  for (int i = 0; i < 3; ++i) regs.transform.row_w[i] = rounded::at<formats::matrix_w>(forward[i]);
  regs.transform.offset_w = d.word<formats::offset_w>(8, 14);
  regs.near = d.word<formats::depth>(6, 16);
  base_vertex a = draw_base_vertex(d), b = draw_base_vertex(d);
  const auto distance = [&](auto rounding, base_vertex const& v) { return clip_distance<decltype(rounding)>(clip_plane::near, v.p, regs); };
  const double da = distance(rounded{}, a), db = distance(rounded{}, b);
  const glm::dvec3 step = glm::abs(a.p - b.p);
  if ((da >= 0) == (db >= 0) || std::abs(da - db) < std::max({1.0, step.x, step.y, step.z}) || glm::dot(a.n, b.n) < -0.5) return 0;
  if (glm::dot(a.t, b.t) < -0.5) return 0;
  const auto off =
      glm::abs(pick(cut_vertex<rounded>(a, b, da, db)) - pick(cut_vertex<exact>(a, b, distance(exact{}, a), distance(exact{}, b))));
  double most = 0;
  for (int i = 0; i < off.length(); ++i) most = std::max(most, off[i] / range_of<F>::lsb);
  return most;
}

inline double extent_error(draw& d) {
  using namespace golden;
  const displace_regs regs{d.word<formats::scale>(-1e-4, 1e-4), d.word<formats::height>(-1, 1)};
  const int high = d.integer(0, 65535), low = d.integer(0, high);
  const auto highest = [high](int, int, int) { return high; };
  const auto lowest = [low](int, int, int) { return low; };
  const map_regs map{37, 23, false, false};
  return std::abs(d_max_of<rounded>({}, map, regs, highest, lowest).d_max - d_max_of<exact>({}, map, regs, highest, lowest).d_max) /
         range_of<formats::extent>::lsb;
}

}  // namespace detail

inline std::map<std::string, std::function<double(draw&)>> world_measurements() {
  using detail::cut_error;
  using vertex = golden::base_vertex const&;
  return {
      {"grid_transform grid", detail::grid_error},
      {"z_table depth_cells", detail::table_error},
      {"near_clip position", [](draw& d) { return cut_error<formats::position>(d, [](vertex v) { return v.p; }); }},
      {"near_clip coordinate", [](draw& d) { return cut_error<formats::coordinate>(d, [](vertex v) { return v.u; }); }},
      {"near_clip colour", [](draw& d) { return cut_error<formats::colour>(d, [](vertex v) { return v.colour; }); }},
      {"near_clip unit",
       [](draw& d) {
         return d.coin() ? cut_error<formats::unit>(d, [](vertex v) { return v.n; })
                         : cut_error<formats::unit>(d, [](vertex v) { return v.t; });
       }},
      {"d_max_of extent", detail::extent_error},
  };
}

}  // namespace relievo::test
