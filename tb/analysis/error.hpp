// error: how far a displaced mesh is from the fully sampled displaced surface, measured at every sample of the map.
//
//   Planar base (one normal, position an affine function of U): along the normal. The mesh is the piecewise-linear
//   function that its vertices span over U; at texel (i, j) it is compared with scale * D(i, j) + bias, D unrounded.
//   Any other base: the distance of the point P(i, j) + (scale * D(i, j) + bias) * N(i, j) to the displaced mesh, P and the
//   normalised N interpolated over the base triangle that holds the texel (Embree point query, the distance itself in
//   double). Patches that use the map separately are each measured at every sample they hold.
//
//   Units: the length unit of the surface ("world"), samples (0..65535), and the physical unit of the range (metres, say).
//   mean is of the absolute error.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "tb/analysis/surface.hpp"

namespace relievo::tb {

struct height_map {
  std::uint16_t const* texels = nullptr;  // width * height, row 0 is v = 0
  int width = 0;
  int height = 0;
  bool wrap_u = false;
  bool wrap_v = false;
  double scale = 0.0;  // world units per sample
  double bias = 0.0;   // world units
  double range_low = 0.0;
  double range_high = 65535.0;  // what sample 65535 stands for
};

struct base_corner {
  glm::dvec3 p{0.0};
  glm::dvec3 n{0.0};
  glm::dvec2 u{0.0};
};
using base_corners = std::array<base_corner, 3>;

struct error_figures {
  double max = 0.0;
  double rms = 0.0;
  double mean = 0.0;
};

struct error_report {
  bool along_normal = false;
  std::uint64_t samples = 0;    // measured
  std::uint64_t uncovered = 0;  // samples under the base that no triangle of the mesh covers (along_normal only)
  error_figures world;
  error_figures in_samples;
  error_figures physical;
  int worst_x = 0;
  int worst_y = 0;
};

error_report measure_error(surface const& displaced, std::vector<base_corners> const& base, height_map const& map);

// True when measure_error would measure along the normal.
bool measures_along_normal(std::vector<base_corners> const& base);

// The yardstick: a regular grid of columns x rows cells over the whole map, each cut along the same diagonal, heights bilinear
// in the map, cells as square and the number of triangles as near to the wanted one as integers allow.
struct uniform_grid_report {
  int columns = 0;
  int rows = 0;
  std::uint64_t triangles = 0;
  error_report error;
};
uniform_grid_report uniform_grid_error(height_map const& map, std::uint64_t triangles);

nlohmann::json to_json(error_report const& report);
nlohmann::json to_json(uniform_grid_report const& report);

}  // namespace relievo::tb
