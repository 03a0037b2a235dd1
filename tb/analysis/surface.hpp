// surface: the plain triangles that measurement and pictures work on, whatever model or file they came from.
//
//   p   displaced position, n displaced normal (need not have unit length), u texture coordinate in texels.
//   Any length unit will do as long as one call sees a single one.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace relievo::tb {

struct surface_vertex {
  glm::dvec3 p{0.0};
  glm::dvec3 n{0.0};
  glm::dvec2 u{0.0};
};

struct surface_triangle {
  std::array<surface_vertex, 3> v{};
  std::uint32_t index = 0;  // base triangle it lies in
};

using surface = std::vector<surface_triangle>;

}  // namespace relievo::tb
