// scene_surface: scenes and engine output as measurement and pictures take them: world units, U in texels.
#pragma once
#include <vector>

#include "golden/edge/triangle.hpp"
#include "tb/analysis/error.hpp"
#include "tb/analysis/surface.hpp"
#include "tb/host/read_mesh.hpp"
#include "tb/host/scene.hpp"

namespace relievo::tb {

// Records with `empty` set are left out.
surface world_surface(std::vector<golden::triangle_out> const& out, scene const& sc);

// A mesh read from a file. Normals that it lacks are made per triangle. input_error when it has no texture coordinates.
surface world_surface(loose_mesh const& file, scene const& sc);

// The base mesh and the map before any rounding: what the output is measured against.
std::vector<base_corners> measured_base(scene const& sc);
height_map measured_map(scene const& sc);

error_report measure_error(std::vector<golden::triangle_out> const& out, scene const& sc);

}  // namespace relievo::tb
