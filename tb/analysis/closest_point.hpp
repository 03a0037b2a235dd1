// closest_point: squared distance of a point to a triangle, in double. By regions of the triangle's plane (Ericson,
// Real-Time Collision Detection, 5.1.5); a triangle without area is handled as its edges.
#pragma once
#include <algorithm>
#include <glm/glm.hpp>

namespace relievo::tb {

inline double squared_distance_to_segment(glm::dvec3 const& p, glm::dvec3 const& a, glm::dvec3 const& b) {
  const glm::dvec3 ab = b - a;
  const double length = glm::dot(ab, ab);
  const double t = length > 0.0 ? std::clamp(glm::dot(p - a, ab) / length, 0.0, 1.0) : 0.0;
  const glm::dvec3 d = p - (a + t * ab);
  return glm::dot(d, d);
}

inline double squared_distance_to_triangle(glm::dvec3 const& p, glm::dvec3 const& a, glm::dvec3 const& b, glm::dvec3 const& c) {
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 normal = glm::cross(ab, ac);
  const double area = glm::dot(normal, normal);
  if (area > 0.0) {
    const glm::dvec3 ap = p - a;
    const double v = glm::dot(glm::cross(ap, ac), normal);
    const double w = glm::dot(glm::cross(ab, ap), normal);
    if (v >= 0.0 && w >= 0.0 && v + w <= area) {
      const double height = glm::dot(ap, normal);
      return height * height / area;
    }
  }
  return std::min({squared_distance_to_segment(p, a, b), squared_distance_to_segment(p, b, c), squared_distance_to_segment(p, c, a)});
}

}  // namespace relievo::tb
