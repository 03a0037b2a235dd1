#include "tb/host/teapot.hpp"

#include <array>
#include <cmath>

#include "tb/host/teapot_patches.hpp"
#include "tb/host/value_index.hpp"

namespace relievo::tb {

namespace {

constexpr double body_radius = 0.567376;

using weights = std::array<double, 4>;

// Bernstein polynomials of degree 3 at a / (a + b), and their derivatives.
weights bernstein(double a, double b) {
  const double n = (a + b) * (a + b) * (a + b);
  return {b * b * b / n, 3.0 * a * b * b / n, 3.0 * a * a * b / n, a * a * a / n};
}
weights bernstein_slope(double a, double b) {
  const double n = (a + b) * (a + b);
  return {-3.0 * b * b / n, 3.0 * (b * b - 2.0 * a * b) / n, 3.0 * (2.0 * a * b - a * a) / n, 3.0 * a * a / n};
}

// Outer terms first, so that the sum is the same bits from either end of the curve.
template <class T>
T weighted(weights const& w, std::array<T, 4> const& x) {
  return (w[0] * x[0] + w[3] * x[3]) + (w[1] * x[1] + w[2] * x[2]);
}

class patch {
 public:
  explicit patch(int index) {
    for (std::size_t i = 0; i < 16; ++i) {
      double const* p = teapot_point[teapot_patch[index][i]];
      // y up to z up, the body's radius to 1.
      points_[i / 4][i % 4] = glm::dvec3(p[0], -p[2], p[1]) / body_radius;
    }
    tip_ = points_[0][0] == points_[0][3];
    if (tip_) points_[0][1] = points_[0][2] = points_[0][0];
  }
  // The first row is one point: the tip of the lid.
  bool has_tip() const { return tip_; }

  glm::dvec3 at(weights const& row, weights const& column) const {
    std::array<glm::dvec3, 4> curve;
    for (std::size_t i = 0; i < 4; ++i) curve[i] = weighted(column, points_[i]);
    return weighted(row, curve);
  }

 private:
  std::array<std::array<glm::dvec3, 4>, 4> points_;
  bool tip_ = false;
};

// Vertex at row r and column c of n, the tip's at the middle column.
base_vertex patch_vertex(patch const& p, double r, double c, double n) {
  base_vertex v;
  v.p = p.at(bernstein(r, n - r), bernstein(c, n - c));
  v.u = glm::dvec2(c / n, 1.0 - r / n);
  // Derivatives vanish at the tip and on rows drawn together into a point; a little beside it they don't.
  constexpr double beside = 1e-4;
  for (double nudge : {0.0, beside, -beside}) {
    const double row = r + nudge * n;
    if (row < 0.0 || row > n) continue;
    const glm::dvec3 along_u = p.at(bernstein(row, n - row), bernstein_slope(c, n - c));
    const glm::dvec3 along_v = -p.at(bernstein_slope(row, n - row), bernstein(c, n - c));
    const glm::dvec3 n_scaled = glm::cross(along_u, along_v);
    if (glm::length(n_scaled) <= 1e-9) continue;
    v.n = glm::normalize(n_scaled);
    v.t = glm::normalize(along_u);
    break;
  }
  return v;
}

void append_patch(mesh& m, patch const& p, int n) {
  const auto first = static_cast<std::uint32_t>(m.vertices.size());
  const auto width = static_cast<std::uint32_t>(n + 1);
  for (int r = 0; r <= n; ++r)
    for (int c = 0; c <= n; ++c) m.vertices.push_back(patch_vertex(p, r, p.has_tip() && r == 0 ? 0.5 * n : c, n));
  for (std::uint32_t r = 0; r + 1 < width; ++r) {
    for (std::uint32_t c = 0; c + 1 < width; ++c) {
      const std::uint32_t a = first + r * width + c, b = a + 1, d = a + width, e = d + 1;
      if (p.has_tip() && r == 0) {
        m.triangles.push_back({first, d, e});
      } else {
        m.triangles.push_back({a, d, e});
        m.triangles.push_back({a, e, b});
      }
    }
  }
}

// One normal where patches meet smoothly.
void join_normals(mesh& m) {
  value_index<3> index(m.vertices.size());
  std::vector<std::vector<std::size_t>> meeting;
  for (std::size_t i = 0; i < m.vertices.size(); ++i) {
    const glm::dvec3 p = m.vertices[i].p;
    const std::uint32_t place = index({p.x, p.y, p.z});
    if (place == meeting.size()) meeting.emplace_back();
    meeting[place].push_back(i);
  }
  constexpr double cosine = 0.7071;
  for (auto& group : meeting) {
    while (!group.empty()) {
      const glm::dvec3 lead = m.vertices[group.front()].n;
      glm::dvec3 sum(0.0);
      std::vector<std::size_t> same, other;
      for (std::size_t i : group) {
        const bool close = glm::dot(m.vertices[i].n, lead) > cosine;
        (close ? same : other).push_back(i);
        if (close) sum += m.vertices[i].n;
      }
      for (std::size_t i : same) m.vertices[i].n = glm::normalize(sum);
      if (same.empty()) break;
      group = other;
    }
  }
}

// Drops the vertices that no triangle uses (the tips' copies).
void drop_unused(mesh& m) {
  std::vector<std::uint32_t> number(m.vertices.size(), 0);
  for (auto const& t : m.triangles)
    for (std::uint32_t i : t) number[i] = 1;
  std::vector<base_vertex> used;
  for (std::size_t i = 0; i < m.vertices.size(); ++i) {
    if (number[i] == 0) continue;
    number[i] = static_cast<std::uint32_t>(used.size());
    used.push_back(m.vertices[i]);
  }
  for (auto& t : m.triangles)
    for (std::uint32_t& i : t) i = number[i];
  m.vertices = std::move(used);
}

}  // namespace

mesh make_teapot(int quads_per_side) {
  mesh m;
  m.has_tangents = true;
  for (int i = 0; i < teapot_patches; ++i) append_patch(m, patch(i), quads_per_side);
  drop_unused(m);
  join_normals(m);
  return m;
}

}  // namespace relievo::tb
