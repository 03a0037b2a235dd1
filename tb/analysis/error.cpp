// error: which way to measure, and the planar way. The distance to a curved surface is in error_distance.cpp.
#include "tb/analysis/error.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "tb/analysis/error_distance.hpp"
#include "tb/analysis/error_sums.hpp"
#include "tb/analysis/texel_raster.hpp"

namespace relievo::tb {
namespace {

// P = origin + u.x * du + u.y * dv with one normal.
struct plane_map {
  glm::dvec3 origin, du, dv, n;
};

double area_in_u(base_corners const& t) {
  const glm::dvec2 a = t[1].u - t[0].u;
  const glm::dvec2 b = t[2].u - t[0].u;
  return a.x * b.y - a.y * b.x;
}

std::optional<plane_map> fit_plane(std::vector<base_corners> const& base) {
  base_corners const* largest = nullptr;
  double most = 0.0;
  double extent = 0.0;
  for (auto const& t : base) {
    if (std::abs(area_in_u(t)) > most) {
      most = std::abs(area_in_u(t));
      largest = &t;
    }
    for (auto const& v : t) extent = std::max(extent, glm::length(v.p - base.front()[0].p));
  }
  if (largest == nullptr) return std::nullopt;
  base_corners const& t = *largest;
  plane_map m;
  m.n = t[0].n;
  const glm::dvec2 a = t[1].u - t[0].u;
  const glm::dvec2 b = t[2].u - t[0].u;
  const glm::dvec3 p = t[1].p - t[0].p;
  const glm::dvec3 q = t[2].p - t[0].p;
  const double whole = area_in_u(t);
  m.du = (p * b.y - q * a.y) / whole;
  m.dv = (q * a.x - p * b.x) / whole;
  m.origin = t[0].p - t[0].u.x * m.du - t[0].u.y * m.dv;
  // Positions and texture coordinates come rounded to their formats: a few words of position over the whole extent, far
  // below what could be called curved.
  const double tolerance = 2e-5 * extent;
  if (glm::dot(m.n, m.n) < 0.5) return std::nullopt;
  if (std::abs(glm::dot(m.du, m.n)) > 1e-3 * glm::length(m.du) || std::abs(glm::dot(m.dv, m.n)) > 1e-3 * glm::length(m.dv)) {
    return std::nullopt;
  }
  for (auto const& other : base) {
    for (auto const& v : other) {
      if (v.n != m.n) return std::nullopt;
      if (glm::length(m.origin + v.u.x * m.du + v.u.y * m.dv - v.p) > tolerance) return std::nullopt;
    }
  }
  return m;
}

class texel_set {
 public:
  texel_set(int width, int height) : width_(width), bits_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}
  bool insert(int x, int y) {
    auto bit = bits_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    if (bit) return false;
    bit = true;
    return true;
  }

 private:
  int width_;
  std::vector<bool> bits_;
};

template <class Visit>
void for_each_texel_once(texel_set& seen, height_map const& map, std::array<glm::dvec2, 3> const& corners, Visit&& visit) {
  raster_texels(corners, [&](int i, int j, glm::dvec3 const& w) {
    const int x = map.wrap_u ? i % map.width : i;
    const int y = map.wrap_v ? j % map.height : j;
    if (x < 0 || y < 0 || x >= map.width || y >= map.height || !seen.insert(x, y)) return;
    visit(x, y, w);
  });
}

error_report measure_along_normal(surface const& displaced, std::vector<base_corners> const& base, plane_map const& plane,
                                  height_map const& map) {
  error_report report;
  report.along_normal = true;
  error_sums sums;
  const double length = glm::dot(plane.n, plane.n);
  texel_set seen(map.width, map.height);
  for (auto const& t : displaced) {
    glm::dvec3 h;
    for (std::size_t k = 0; k < 3; ++k) h[static_cast<glm::length_t>(k)] = glm::dot(t.v[k].p - plane.origin, plane.n) / length;
    for_each_texel_once(seen, map, {t.v[0].u, t.v[1].u, t.v[2].u}, [&](int x, int y, glm::dvec3 const& w) {
      const double d = map.texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(x)];
      sums.add(glm::dot(h, w) - (map.scale * d + map.bias), x, y);
    });
  }
  for (auto const& t : base) {
    for_each_texel_once(seen, map, {t[0].u, t[1].u, t[2].u}, [&](int, int, glm::dvec3 const&) { ++report.uncovered; });
  }
  sums.fill(report, map);
  return report;
}

nlohmann::json to_json(error_figures const& f) { return {{"max", f.max}, {"rms", f.rms}, {"mean", f.mean}}; }

}  // namespace

bool measures_along_normal(std::vector<base_corners> const& base) { return fit_plane(base).has_value(); }

error_report measure_error(surface const& displaced, std::vector<base_corners> const& base, height_map const& map) {
  if (const auto plane = fit_plane(base)) return measure_along_normal(displaced, base, *plane, map);
  return measure_distance(displaced, base, map);
}

nlohmann::json to_json(error_report const& report) {
  return {{"along_normal", report.along_normal},
          {"samples_measured", report.samples},
          {"samples_uncovered", report.uncovered},
          {"world", to_json(report.world)},
          {"samples", to_json(report.in_samples)},
          {"physical", to_json(report.physical)},
          {"worst_texel", {report.worst_x, report.worst_y}}};
}

nlohmann::json to_json(uniform_grid_report const& report) {
  return {{"columns", report.columns}, {"rows", report.rows}, {"triangles", report.triangles}, {"error", to_json(report.error)}};
}

}  // namespace relievo::tb
