// open_edges: vertices that lie inside an edge used once, found geometrically.
//
//   A T-vertex is itself the end of open edges, so only those are looked at. A vertex lies inside an edge when it is neither of its
//   ends, its foot is strictly between them and its distance is within the tolerance; with use_u the same holds in U, modulo the turn
//   of a wrapped axis (0: not wrapped), and with use_t its tangent is near the ends' (within 25 degrees, which no interpolation
//   exceeds that hasn't lost its direction), so that a vertex across a border doesn't count. Each vertex is returned once, in order.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace relievo::tb {

struct open_vertex {
  glm::dvec3 p{0.0};
  glm::dvec2 u{0.0};
  std::uint32_t identity = 0;
  glm::dvec3 t{0.0};
};

struct open_tolerance {
  double position = 0.0;
  bool use_u = false;
  double coordinate = 0.0;
  glm::dvec2 turn{0.0};
  bool use_t = false;
};

double distance_to_segment(glm::dvec3 const& x, glm::dvec3 const& a, glm::dvec3 const& b);

std::vector<std::uint32_t> vertices_inside_open_edges(std::vector<open_vertex> const& vertices,
                                                      std::vector<std::array<std::uint32_t, 2>> const& edges,
                                                      open_tolerance const& tolerance);

}  // namespace relievo::tb
