// shading: light and colour of the pictures. Brightness 0..1, then one ramp of 256 colours.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace relievo::tb::shading {

inline constexpr double background = 1.0;
inline constexpr double line = 0.12;

// Dark slate over stone to paper white; evenly spaced in brightness.
inline std::array<std::uint8_t, 3> ramp(double brightness) {
  struct stop {
    double at, r, g, b;
  };
  constexpr std::array<stop, 6> stops = {
      {{0.00, 22, 27, 38}, {0.20, 58, 68, 84}, {0.45, 122, 126, 128}, {0.70, 188, 180, 164}, {0.90, 232, 223, 205}, {1.00, 255, 255, 255}}};
  const double x = std::floor(std::clamp(brightness, 0.0, 1.0) * 255.0 + 0.5) / 255.0;
  std::size_t i = 1;
  while (i + 1 < stops.size() && x > stops[i].at) ++i;
  stop const& a = stops[i - 1];
  stop const& b = stops[i];
  const double f = (x - a.at) / (b.at - a.at);
  const auto byte = [f](double p, double q) { return static_cast<std::uint8_t>(std::floor(p + f * (q - p) + 0.5)); };
  return {byte(a.r, b.r), byte(a.g, b.g), byte(a.b, b.b)};
}

// Directions about +z for ambient occlusion, cosine-weighted, from a golden-angle spiral.
inline std::vector<glm::dvec3> hemisphere(int count) {
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < count; ++i) {
    const double r2 = (i + 0.5) / count;
    const double angle = i * 2.399963229728653;
    const double r = std::sqrt(r2);
    directions.emplace_back(r * std::cos(angle), r * std::sin(angle), std::sqrt(1.0 - r2));
  }
  return directions;
}

// n and to_light have unit length; up is the camera's. open: share of the sky that is seen; lit: 0 in shadow.
inline double brightness(glm::dvec3 const& n, glm::dvec3 const& to_light, glm::dvec3 const& up, double open, double lit) {
  const double key = std::max(0.0, glm::dot(n, to_light)) * lit;
  const double sky = 0.5 + 0.5 * glm::dot(n, up);
  return std::min(0.93, (0.10 + 0.22 * sky) * (0.25 + 0.75 * open) + 0.68 * key);
}

}  // namespace relievo::tb::shading
