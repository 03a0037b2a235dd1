// mesh_target: what has to hold for a mesh that a reader lets through, whatever the bytes were.
#pragma once
#include <cmath>
#include <cstdlib>

#include "tb/host/mesh.hpp"

namespace relievo::test {

inline void use(tb::mesh m) {
  for (auto const& t : m.triangles)
    for (std::uint32_t i : t)
      if (i >= m.vertices.size()) std::abort();
  if (!m.undisplaced.empty() && m.undisplaced.size() != m.vertices.size()) std::abort();
  if (!m.raw.empty() && m.raw.size() != m.vertices.size()) std::abort();
  if (!m.base_triangle.empty() && m.base_triangle.size() != m.triangles.size()) std::abort();
  std::vector<std::uint32_t> classes;
  for (std::uint32_t i = 0; i < m.vertices.size(); ++i) classes.push_back(i);
  tb::is_planar(m);
  tb::estimate_texel_size(m, glm::dvec2(16.0, 16.0));
  tb::complete_tangents(m, classes);
  for (auto const& v : m.vertices)
    if (!(std::abs(glm::length(v.t) - 1.0) < 1e-6) || !(std::abs(glm::dot(v.t, v.n)) < 1e-6)) std::abort();
}

}  // namespace relievo::test
