// golden_scene: a displaced plane through the golden engine, for the tests of golden and ideal alone.
//
//   golden_scene s(width, height, wrap, formula)   texels are formula(x, y); no test is on, the camera looks down from z = 3
//   s.plane(columns, rows)                         base triangles: z = 0, x in [-1, 1] along u, y along v by the map's aspect
//   s.displace(scale, bias)                        sets the registers of displace and of the normal map, which fit any slope of the map
//   s.run<Rounding>(observer)                      -> counters and the output triangles
//   areas(result, base)                            per base triangle the sum of output areas times 2^120, exact; -1 for a flip
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "golden/edge/engine.hpp"

namespace relievo::test {

__extension__ typedef __int128 int128;

struct golden_result {
  golden::counters counts;
  std::vector<golden::triangle_out> triangles;  // without the empty record
  int lasts = 0;
};

class golden_scene {
 public:
  template <class Formula>
  golden_scene(int width, int height, bool wrap, Formula&& formula) {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) texels.push_back(static_cast<std::uint16_t>(std::clamp(std::round(formula(x, y)), 0.0, 65535.0)));
    table = golden::summed_area_table(texels.data(), width, height);
    regs.map = {static_cast<double>(width), static_cast<double>(height), wrap, wrap};
    regs.transform.row_x = {200, 0, 0};
    regs.transform.row_y = {0, 200, 0};
    regs.transform.row_w = {0, 0, -1};
    regs.transform.offset_w = 3;
    regs.transform.w_min = 1 / 256.0;
    for (int i = 0; i < 3; ++i) regs.transform_normal.rotation[i][i] = 1;
    regs.transform_normal.eye = {0, 0, 3};
    regs.highlight.half_vector = {0, 0, 1};
    displace(0.25 / 65535, 0);
  }

  // Extent of the plane: the longer side is 2.
  glm::dvec2 size() const {
    const glm::dvec2 span = last_coordinate();
    return 2.0 * span / std::max(span.x, span.y);
  }
  glm::dvec2 last_coordinate() const {
    return {std::max(1.0, regs.map.width - (regs.map.wrap_u ? 0 : 1)), std::max(1.0, regs.map.height - (regs.map.wrap_v ? 0 : 1))};
  }

  void displace(double scale, double bias) {
    using golden::rounded;
    regs.displace = {rounded::at<formats::scale>(scale), rounded::at<formats::height>(bias)};
    const glm::dvec2 texel = size() / last_coordinate();
    int e = 0;
    const double steepest = std::abs(scale) / (2 * std::min(texel.x, texel.y)) * 2 * 65535;
    while (std::ldexp(steepest, -e) >= 7.9) ++e;
    normal_map = {rounded::at<formats::gradient>(std::ldexp(scale / (2 * texel.x), -e)),
                  rounded::at<formats::gradient>(std::ldexp(scale / (2 * texel.y), -e)), static_cast<double>(e)};
  }

  void plane(int columns, int rows) {
    base.clear();
    const auto corner = [&](int x, int y) {
      const glm::dvec2 at(static_cast<double>(x) / columns, static_cast<double>(y) / rows);
      golden::vertex v;
      for (int i = 0; i < 2; ++i) {
        v.p[i] = golden::rounded::at<formats::position>((at[i] - 0.5) * size()[i]);
        v.u[i] = golden::rounded::at<formats::coordinate>(at[i] * (last_coordinate()[i] - (regs.map.width == 1 ? 1 : 0)));
      }
      v.n = {0, 0, 1};
      v.t = {1, 0, 0};
      return v;
    };
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        add(corner(x, y), corner(x + 1, y), corner(x + 1, y + 1));
        add(corner(x, y), corner(x + 1, y + 1), corner(x, y + 1));
      }
  }

  void add(golden::vertex const& a, golden::vertex const& b, golden::vertex const& c) {
    golden::triangle t;
    t.v[0] = a;
    t.v[1] = b;
    t.v[2] = c;
    t.index = static_cast<double>(base.size());
    base.push_back(t);
  }

  // Every edge splits until something stops it.
  void always_split(int max_generation) {
    regs.pass.use_ht = true;
    regs.highlight.threshold = -2;
    regs.pass.max_generation = max_generation;
  }

  golden::memories memories() const { return {texels.data(), table.data(), normal_map}; }

  template <class Rounding, class Observer>
  golden_result run(Observer&& observer) const {
    const auto smallest = static_cast<std::size_t>(3 * regs.pass.max_generation + 4);
    golden::engine<Rounding> engine(regs, memories(), smallest);
    golden_result result;
    std::size_t i = 0;
    const auto next = [&](golden::triangle& t) {
      if (i == base.size()) return false;
      t = base[i++];
      return true;
    };
    const auto out = [&result](golden::triangle_out const& t) {
      if (!t.empty) result.triangles.push_back(t);
      result.lasts += t.last ? 1 : 0;
    };
    result.counts = engine.run(next, out, observer);
    return result;
  }
  template <class Rounding>
  golden_result run() const {
    return run<Rounding>([](golden::edge_trace const&) {});
  }

  std::vector<std::uint16_t> texels;
  std::vector<std::uint64_t> table;
  golden::engine_regs regs;
  golden::normal_map_regs normal_map;
  std::vector<golden::triangle> base;
};

inline std::vector<int128> areas(golden_result const& result, std::size_t base) {
  std::vector<int128> sums(base, 0);
  for (golden::triangle_out const& t : result.triangles) {
    const auto edge = [&t](std::size_t to, std::size_t axis) {
      return static_cast<int128>(t.v[to].barycentric[axis]) - t.v[0].barycentric[axis];
    };
    const int128 area = edge(1, 1) * edge(2, 2) - edge(1, 2) * edge(2, 1);
    int128& sum = sums[static_cast<std::size_t>(t.index)];
    sum = area <= 0 || sum < 0 ? -1 : sum + area;
  }
  return sums;
}

}  // namespace relievo::test
