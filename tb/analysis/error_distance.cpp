#include "tb/analysis/error_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include "tb/analysis/closest_point.hpp"
#include "tb/analysis/embree.hpp"
#include "tb/analysis/error_sums.hpp"
#include "tb/analysis/progress.hpp"
#include "tb/analysis/texel_raster.hpp"

namespace relievo::tb {
namespace {

// Closest distance to the displaced mesh. Embree narrows the candidates in float, the distance itself is double.
class distance_field {
 public:
  explicit distance_field(surface const& triangles)
      : triangles_(triangles), device_(make_embree_device()), scene_(make_embree_scene(device_.get(), triangles, &candidate)) {
    double extent = 0.0;
    for (auto const& t : triangles) {
      for (auto const& v : t.v) extent = std::max({extent, std::abs(v.p.x), std::abs(v.p.y), std::abs(v.p.z)});
    }
    slack_ = 4.0 * extent * static_cast<double>(std::numeric_limits<float>::epsilon());
  }

  double operator()(glm::dvec3 const& p) {
    if (triangles_.empty()) return 0.0;
    search s{this, p, distance_squared(p, last_), last_};
    RTCPointQuery query{};
    query.x = static_cast<float>(p.x);
    query.y = static_cast<float>(p.y);
    query.z = static_cast<float>(p.z);
    query.time = 0.0f;
    query.radius = radius(s.best);
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_.get(), &query, &context, nullptr, &s);
    last_ = s.nearest;  // the next sample is a neighbour: its search starts with a small ball
    return std::sqrt(s.best);
  }

 private:
  struct search {
    distance_field* field;
    glm::dvec3 p;
    double best;
    std::size_t nearest;
  };

  double distance_squared(glm::dvec3 const& p, std::size_t i) const {
    auto const& v = triangles_[i].v;
    return squared_distance_to_triangle(p, v[0].p, v[1].p, v[2].p);
  }

  // Rounded up by what float positions may be off, so that no candidate is lost.
  float radius(double squared) const { return static_cast<float>((std::sqrt(squared) + slack_) * (1.0 + 1e-6)); }

  static bool candidate(RTCPointQueryFunctionArguments* arguments) {
    auto& s = *static_cast<search*>(arguments->userPtr);
    const double d = s.field->distance_squared(s.p, arguments->primID);
    if (d >= s.best) return false;
    s.best = d;
    s.nearest = arguments->primID;
    arguments->query->radius = s.field->radius(d);
    return true;
  }

  surface const& triangles_;
  embree_device device_;
  embree_scene scene_;
  double slack_ = 0.0;
  std::size_t last_ = 0;
};

// Base triangles by chart: union by vertices that agree in P and U.
std::vector<std::vector<std::size_t>> charts(std::vector<base_corners> const& base) {
  std::vector<std::size_t> parent(base.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  using key = std::tuple<double, double, double, double, double>;
  std::map<key, std::size_t> first;
  for (std::size_t i = 0; i < base.size(); ++i) {
    for (auto const& v : base[i]) {
      const auto [at, fresh] = first.try_emplace(key{v.p.x, v.p.y, v.p.z, v.u.x, v.u.y}, i);
      if (!fresh) parent[std::max(root(i), root(at->second))] = std::min(root(i), root(at->second));
    }
  }
  std::vector<std::vector<std::size_t>> result;
  std::map<std::size_t, std::size_t> place;
  for (std::size_t i = 0; i < base.size(); ++i) {
    const auto [at, fresh] = place.try_emplace(root(i), result.size());
    if (fresh) result.emplace_back();
    result[at->second].push_back(i);
  }
  return result;
}

// Texels already measured in the chart at hand: a word per texel holds the last chart that took it.
class chart_texels {
 public:
  chart_texels(int width, int height) : width_(width), owner_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0) {}
  bool insert(int x, int y, std::uint16_t chart) {
    auto& owner = owner_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    if (owner == chart) return false;
    owner = chart;
    return true;
  }
  void clear() { std::fill(owner_.begin(), owner_.end(), std::uint16_t{0}); }

 private:
  int width_;
  std::vector<std::uint16_t> owner_;
};

}  // namespace

error_report measure_distance(surface const& displaced, std::vector<base_corners> const& base, height_map const& map) {
  error_report report;
  error_sums sums;
  distance_field distance(displaced);
  chart_texels seen(map.width, map.height);
  std::uint16_t stamp = 0;
  progress bar("distance to the displaced surface, base triangles", base.size());
  for (auto const& chart : charts(base)) {
    if (++stamp == 0) {
      seen.clear();
      stamp = 1;
    }
    for (const std::size_t b : chart) {
      base_corners const& t = base[b];
      raster_texels({t[0].u, t[1].u, t[2].u}, [&](int i, int j, glm::dvec3 const& w) {
        const int x = map.wrap_u ? i % map.width : i;
        const int y = map.wrap_v ? j % map.height : j;
        if (x < 0 || y < 0 || x >= map.width || y >= map.height || !seen.insert(x, y, stamp)) return;
        const glm::dvec3 p = w.x * t[0].p + w.y * t[1].p + w.z * t[2].p;
        const glm::dvec3 n = w.x * t[0].n + w.y * t[1].n + w.z * t[2].n;
        const double length = glm::length(n);
        const double d = map.texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(x)];
        const double height = map.scale * d + map.bias;
        sums.add(distance(length > 0.0 ? p + height / length * n : p), x, y);
      });
      bar.advance();
    }
  }
  sums.fill(report, map);
  if (displaced.empty()) {
    report.uncovered = report.samples;
    report.samples = 0;
  }
  return report;
}

}  // namespace relievo::tb
