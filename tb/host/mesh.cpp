#include "tb/host/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "tb/host/input_error.hpp"
#include "tb/host/quantise.hpp"
#include "tb/host/value_index.hpp"

namespace relievo::tb {

namespace {

constexpr double largest_coordinate = 1e9;

bool usable(glm::dvec3 v) {
  for (int i = 0; i < 3; ++i)
    if (!std::isfinite(v[i]) || std::abs(v[i]) > largest_coordinate) return false;
  return true;
}

void check_vertices(mesh& m) {
  for (std::size_t i = 0; i < m.vertices.size(); ++i) {
    base_vertex& v = m.vertices[i];
    const auto place = [&] { return m.name + ": vertex " + std::to_string(i); };
    if (!usable(v.p)) throw input_error(place() + ": the position is not finite or beyond 1e9");
    if (!usable(v.n)) throw input_error(place() + ": the normal is not finite or beyond 1e9");
    if (!usable(v.t)) throw input_error(place() + ": the tangent is not finite or beyond 1e9");
    if (!usable(glm::dvec3(v.u, 0.0))) throw input_error(place() + ": the texture coordinate is not finite or beyond 1e9");
    // Scaled first, so that neither huge nor tiny vectors lose their length to the range of a double.
    const double largest = std::max({std::abs(v.n.x), std::abs(v.n.y), std::abs(v.n.z)});
    if (largest < 1e-30) throw input_error(place() + ": the normal has no length");
    v.n = glm::normalize(v.n / largest);
  }
}

// Each directed edge once, its reverse at most once: what a surface with an inside and an outside looks like.
void check_edges(mesh const& m) {
  value_index<8> same(m.vertices.size());
  std::vector<std::uint32_t> number(m.vertices.size());
  for (std::size_t i = 0; i < m.vertices.size(); ++i) {
    const base_vertex& v = m.vertices[i];
    number[i] = same({v.p.x, v.p.y, v.p.z, v.n.x, v.n.y, v.n.z, v.u.x, v.u.y});
  }
  struct use {
    std::size_t forward = 0, backward = 0;
    std::size_t first = 0;
  };
  std::unordered_map<std::uint64_t, use> edges;
  edges.reserve(m.triangles.size() * 2);
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    for (std::size_t e = 0; e < 3; ++e) {
      const std::uint64_t a = number[m.triangles[i][e]], b = number[m.triangles[i][(e + 1) % 3]];
      if (a == b) continue;  // no length: a zero-area triangle
      const auto [found, added] = edges.emplace(a < b ? a << 32 | b : b << 32 | a, use{});
      use& u = found->second;
      if (added) u.first = i;
      ++(a < b ? u.forward : u.backward);
      if (u.forward + u.backward > 2)
        throw input_error(m.name + ": triangle " + std::to_string(i) + ": a third triangle at the edge of triangle " +
                          std::to_string(u.first) + "; the mesh has to be manifold");
      if (u.forward > 1 || u.backward > 1)
        throw input_error(m.name + ": triangle " + std::to_string(i) + ": runs along the edge of triangle " + std::to_string(u.first) +
                          " in the same direction; one of them is turned over");
    }
  }
}

}  // namespace

void check_base_mesh(mesh& m) {
  if (m.triangles.empty()) throw input_error(m.name + ": no triangles; at least one is needed");
  check_vertices(m);
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    const auto& t = m.triangles[i];
    for (std::uint32_t index : t)
      if (index >= m.vertices.size())
        throw input_error(m.name + ": triangle " + std::to_string(i) + ": index " + std::to_string(index) + " is out of range; there are " +
                          std::to_string(m.vertices.size()) + " vertices");
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      throw input_error(m.name + ": triangle " + std::to_string(i) + ": is degenerate, two of its corners are the same vertex");
  }
  check_edges(m);
}

bool is_planar(mesh const& m) {
  if (m.vertices.empty()) return false;
  const base_vertex& first = m.vertices.front();
  glm::dvec3 low = first.p, high = first.p;
  for (base_vertex const& v : m.vertices) {
    low = glm::min(low, v.p);
    high = glm::max(high, v.p);
  }
  const double tolerance = 1e-9 * glm::length(high - low);
  return std::all_of(m.vertices.begin(), m.vertices.end(), [&](base_vertex const& v) {
    return glm::length(v.n - first.n) <= 1e-9 && std::abs(glm::dot(v.p - first.p, first.n)) <= tolerance;
  });
}

}  // namespace relievo::tb
