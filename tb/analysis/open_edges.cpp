#include "tb/analysis/open_edges.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo::tb {
namespace {

// Edges along the axes are common, so vertices are sorted along a direction that is near none of them.
double sort_key(glm::dvec3 const& p) { return glm::dot(p, glm::dvec3(0.5377, 0.6441, 0.5441)); }

// Brings u within half a turn of `near`.
double beside(double u, double near, double turn) { return turn > 0.0 ? u - turn * std::round((u - near) / turn) : u; }

bool inside(open_vertex const& x, open_vertex const& a, open_vertex const& b, open_tolerance const& tolerance) {
  if (x.identity == a.identity || x.identity == b.identity) return false;
  const glm::dvec3 ab = b.p - a.p;
  const double along = glm::dot(x.p - a.p, ab);
  if (along <= 0.0 || along >= glm::dot(ab, ab)) return false;
  if (distance_to_segment(x.p, a.p, b.p) > tolerance.position) return false;
  if (tolerance.use_t) {
    const glm::dvec3 t = a.t + (along / glm::dot(ab, ab)) * (b.t - a.t);
    if (glm::dot(t, x.t) < 0.9 * glm::length(t) * glm::length(x.t)) return false;
  }
  if (!tolerance.use_u) return true;
  const glm::dvec2 middle = 0.5 * (a.u + b.u);
  const glm::dvec3 u(beside(x.u.x, middle.x, tolerance.turn.x), beside(x.u.y, middle.y, tolerance.turn.y), 0.0);
  return distance_to_segment(u, {a.u, 0.0}, {b.u, 0.0}) <= tolerance.coordinate;
}

}  // namespace

double distance_to_segment(glm::dvec3 const& x, glm::dvec3 const& a, glm::dvec3 const& b) {
  const glm::dvec3 ab = b - a;
  const double length = glm::dot(ab, ab);
  const double t = length > 0.0 ? std::clamp(glm::dot(x - a, ab) / length, 0.0, 1.0) : 0.0;
  return glm::length(x - (a + t * ab));
}

std::vector<std::uint32_t> vertices_inside_open_edges(std::vector<open_vertex> const& vertices,
                                                      std::vector<std::array<std::uint32_t, 2>> const& edges,
                                                      open_tolerance const& tolerance) {
  struct candidate {
    double key;
    std::uint32_t vertex;
  };
  std::vector<std::uint32_t> ends;
  for (auto const& e : edges) ends.insert(ends.end(), e.begin(), e.end());
  const auto by_identity = [&](std::uint32_t a, std::uint32_t b) {
    return vertices[a].identity != vertices[b].identity ? vertices[a].identity < vertices[b].identity : a < b;
  };
  std::sort(ends.begin(), ends.end(), by_identity);
  ends.erase(std::unique(ends.begin(), ends.end(), [&](auto a, auto b) { return vertices[a].identity == vertices[b].identity; }),
             ends.end());
  std::vector<candidate> candidates;
  candidates.reserve(ends.size());
  for (const std::uint32_t v : ends) candidates.push_back({sort_key(vertices[v].p), v});
  std::sort(candidates.begin(), candidates.end(), [](candidate const& a, candidate const& b) { return a.key < b.key; });

  std::vector<std::uint32_t> found;
  for (auto const& e : edges) {
    double first = sort_key(vertices[e[0]].p);
    double last = sort_key(vertices[e[1]].p);
    if (first > last) std::swap(first, last);
    auto c = std::lower_bound(candidates.begin(), candidates.end(), first - tolerance.position,
                              [](candidate const& a, double key) { return a.key < key; });
    for (; c != candidates.end() && c->key <= last + tolerance.position; ++c) {
      if (inside(vertices[c->vertex], vertices[e[0]], vertices[e[1]], tolerance)) found.push_back(c->vertex);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace relievo::tb
