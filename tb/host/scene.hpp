// scene: everything an engine needs, brought into the formats once.
//
//   engine = (world - centre) * world_scale. world_scale is a power of two, the largest for which the mesh with its displacement stays
//   within 15/16 of the position format; centre is 0 unless the mesh lies so far off that two bits or more would be lost. Texture
//   coordinates: u * (W - 1) on a clamped axis, u * W on a wrapped one, rounded to the coordinate format; outside the map is refused.
//   Normals and tangents are normalised, then rounded. Displacement in world units = bias + scale * sample / 65535.
//   The map's normals: gradient_u = s / (2 du) * 2^-normal_shift, with the smallest shift that lets the steepest slope of this map fit.
//   Errors: input_error for everything that does not fit its register, named by the option.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "golden/edge/engine_regs.hpp"
#include "golden/edge/triangle.hpp"
#include "golden/surface/normal_map.hpp"
#include "golden/sweep/engine_data.hpp"
#include "tb/host/camera.hpp"
#include "tb/host/map.hpp"
#include "tb/host/mesh.hpp"
#include "tb/host/scene_options.hpp"

namespace relievo::tb {

struct scene {
  scene_options options;  // with every default filled in
  mesh base;              // world units, tangents complete
  displacement_map map;
  camera_view camera;  // world units
  double world_scale = 1.0;
  glm::dvec3 centre{0.0};
  glm::dvec2 texel_size{1.0};  // world units

  std::vector<golden::triangle> triangles;  // engine units, quantised; the last one carries `last`; all, or options.base_triangle
  golden::engine_regs regs;
  golden::sweep_regs sweep;  // when options.engine is sweep
  int row_exponent = 0;      // w is in engine units times 2^row_exponent (camera.hpp)
  golden::normal_map_regs normal_map;
  std::vector<std::string> warnings;  // for stderr: one line each

  glm::dvec3 to_world(glm::dvec3 engine) const { return engine / world_scale + centre; }
  glm::dvec3 from_world(glm::dvec3 world) const { return (world - centre) * world_scale; }
  // Texels that u, v = 0..1 span, and texture coordinates there and back (0 on a clamped axis of one sample).
  glm::dvec2 texels_per_unit() const;
  glm::dvec2 to_texels(glm::dvec2 u) const { return u * texels_per_unit(); }
  glm::dvec2 from_texels(glm::dvec2 texels) const;
  // World units of displacement per sample, and the sample range's units per sample (1 without one).
  double world_per_sample() const { return options.scale / 65535.0; }
  double physical_per_sample() const;
  // The physical value of a sample: low + (high - low) * sample / 65535, or the sample itself.
  double physical(double sample) const;
};

scene make_scene(scene_options const& options);

// The same from a mesh and a map that are already there (options.mesh and options.displacement are names for messages).
scene make_scene(scene_options const& options, mesh base, displacement_map map);

// The same scene with one of its base triangles alone. input_error, naming --base-triangle, when it has no such triangle.
scene only_base_triangle(scene sc, int index);

}  // namespace relievo::tb
