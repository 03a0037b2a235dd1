// tangents: what a parametrisation says about directions and sizes on a mesh (complete_tangents, estimate_texel_size of mesh.hpp).
#include <algorithm>
#include <cmath>
#include <numeric>

#include "tb/host/input_error.hpp"
#include "tb/host/mesh.hpp"

namespace relievo::tb {

namespace {

// P as a linear function of u over one triangle.
struct derivatives {
  glm::dvec3 du{0.0}, dv{0.0};  // dP/du, dP/dv, per unit of u, v
  glm::dvec3 area{0.0};         // (p1 - p0) x (p2 - p0)
  double det = 0.0;             // twice the signed area in u
  double sliver = 0.0;          // the smaller of the sines at vertex 0, in u and in p
};

derivatives differentiate(mesh const& m, std::array<std::uint32_t, 3> const& t) {
  const base_vertex &a = m.vertices[t[0]], &b = m.vertices[t[1]], &c = m.vertices[t[2]];
  const glm::dvec3 p1 = b.p - a.p, p2 = c.p - a.p;
  const glm::dvec2 u1 = b.u - a.u, u2 = c.u - a.u;
  derivatives d;
  d.det = u1.x * u2.y - u2.x * u1.y;
  d.area = glm::cross(p1, p2);
  const double in_u = glm::length(u1) * glm::length(u2), in_p = glm::length(p1) * glm::length(p2);
  if (in_u > 0.0 && in_p > 0.0) d.sliver = std::fmin(std::abs(d.det) / in_u, glm::length(d.area) / in_p);
  if (d.det != 0.0) {
    d.du = (p1 * u2.y - p2 * u1.y) / d.det;
    d.dv = (p2 * u1.x - p1 * u2.x) / d.det;
  }
  return d;
}

// Thinner triangles say nothing reliable about direction once their corners are rounded, in text files above all.
constexpr double thinnest = 1e-6;

glm::dvec3 any_orthogonal(glm::dvec3 n) {
  const glm::dvec3 a = glm::abs(n);
  const glm::dvec3 axis = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0) : a.y <= a.z ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  return glm::normalize(axis - n * glm::dot(n, axis));
}

// The direction of t orthogonal to n.
glm::dvec3 orthogonal(glm::dvec3 t, glm::dvec3 n) {
  const double length = glm::length(t);
  if (!(length > 0.0)) return any_orthogonal(n);
  t /= length;
  t -= n * glm::dot(n, t);
  // Twice, since cancellation leaves a component along n when t was nearly parallel to it.
  t -= n * glm::dot(n, t);
  const double left = glm::length(t);
  return left > 1e-6 ? t / left : any_orthogonal(n);
}

// A triangle is mirrored when going round it in u turns the other way than going round it in space, seen along the normals of all its
// corners.
bool is_mirrored(mesh const& m, std::array<std::uint32_t, 3> const& t, derivatives const& d) {
  if (d.sliver < 1e-3) return false;
  const glm::dvec3 face = glm::normalize(d.area) * (d.det > 0.0 ? 1.0 : -1.0);
  return std::all_of(t.begin(), t.end(), [&](std::uint32_t i) { return glm::dot(face, m.vertices[i].n) < -0.5; });
}

// The pieces of a surface that hang together: every class of vertices leads to its piece's first.
class pieces {
 public:
  explicit pieces(std::size_t classes) : leader_(classes) { std::iota(leader_.begin(), leader_.end(), 0u); }
  std::uint32_t of(std::uint32_t i) {
    while (leader_[i] != i) i = leader_[i] = leader_[leader_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { leader_[of(a)] = of(b); }

 private:
  std::vector<std::uint32_t> leader_;
};

// Mirrored is a piece of the surface, or the half of one; single triangles may be turned over where a displaced mesh, the base of a second
// pass, folds into itself.
constexpr double largest_fold = 0.25;

void refuse_mirrored(mesh const& m, std::vector<std::uint32_t> const& vertex_class, std::uint32_t classes) {
  pieces surface(classes);
  for (auto const& t : m.triangles)
    for (std::size_t e = 0; e < 3; ++e) surface.join(vertex_class[t[e]], vertex_class[t[(e + 1) % 3]]);
  struct share {
    double whole = 0.0, mirrored = 0.0;
    std::size_t first = 0;
  };
  std::vector<share> shares(classes);
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    const derivatives d = differentiate(m, m.triangles[i]);
    share& s = shares[surface.of(vertex_class[m.triangles[i][0]])];
    const double area = glm::length(d.area);
    s.whole += area;
    if (!is_mirrored(m, m.triangles[i], d)) continue;
    if (s.mirrored == 0.0) s.first = i;
    s.mirrored += area;
  }
  for (share const& s : shares)
    if (s.mirrored > largest_fold * s.whole)
      throw input_error(m.name + ": triangle " + std::to_string(s.first) +
                        ": its texture coordinates are mirrored; u to the right and v up are needed, seen along the normal from outside");
}

}  // namespace

void complete_tangents(mesh& m, std::vector<std::uint32_t> const& vertex_class) {
  std::uint32_t classes = 0;
  for (std::uint32_t number : vertex_class) classes = std::max(classes, number + 1);
  refuse_mirrored(m, vertex_class, classes);
  if (!m.has_tangents) {
    std::vector<glm::dvec3> sum(classes, glm::dvec3(0.0));
    for (auto const& t : m.triangles) {
      const derivatives d = differentiate(m, t);
      const double length = glm::length(d.du);
      if (d.sliver < thinnest || !(length > 0.0)) continue;
      for (std::uint32_t index : t) sum[vertex_class[index]] += d.du / length * glm::length(d.area);
    }
    for (std::size_t i = 0; i < m.vertices.size(); ++i) m.vertices[i].t = sum[vertex_class[i]];
    m.has_tangents = true;
  }
  for (base_vertex& v : m.vertices) v.t = orthogonal(v.t, v.n);
}

std::optional<glm::dvec2> estimate_texel_size(mesh const& m, glm::dvec2 texels_per_unit) {
  double total = 0.0;
  glm::dvec2 sum(0.0);
  for (auto const& t : m.triangles) {
    const derivatives d = differentiate(m, t);
    if (d.sliver < thinnest) continue;
    const double area = glm::length(d.area);
    sum += glm::dvec2(glm::length(d.du), glm::length(d.dv)) * area;
    total += area;
  }
  if (!(total > 0.0)) return std::nullopt;
  glm::dvec2 size(1.0);
  for (int i = 0; i < 2; ++i)
    if (texels_per_unit[i] > 0.0) size[i] = sum[i] / total / texels_per_unit[i];
  return size;
}

}  // namespace relievo::tb
