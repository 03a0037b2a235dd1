#include "tb/analysis/scene_surface.hpp"

#include "tb/host/input_error.hpp"

namespace relievo::tb {

surface world_surface(std::vector<golden::triangle_out> const& out, scene const& sc) {
  surface result;
  result.reserve(out.size());
  for (auto const& t : out) {
    if (t.empty) continue;
    surface_triangle s;
    for (std::size_t k = 0; k < 3; ++k) s.v[k] = {sc.to_world(t.v[k].displaced_p), t.v[k].displaced_n, t.v[k].u};
    s.index = static_cast<std::uint32_t>(t.index);
    result.push_back(s);
  }
  return result;
}

surface world_surface(loose_mesh const& file, scene const& sc) {
  if (!file.has_coordinates) {
    throw input_error(file.m.name + ": no texture coordinates; the error is measured over them (.ply and .obj of ours have them)");
  }
  surface result;
  result.reserve(file.m.triangles.size());
  for (std::size_t i = 0; i < file.m.triangles.size(); ++i) {
    surface_triangle s;
    for (std::size_t k = 0; k < 3; ++k) {
      base_vertex const& v = file.m.vertices[file.m.triangles[i][k]];
      s.v[k] = {v.p, v.n, sc.to_texels(v.u)};
    }
    if (!file.has_normals) {
      const glm::dvec3 n = glm::cross(s.v[1].p - s.v[0].p, s.v[2].p - s.v[0].p);
      for (auto& v : s.v) v.n = n;
    }
    if (i < file.m.base_triangle.size()) s.index = file.m.base_triangle[i];
    result.push_back(s);
  }
  return result;
}

std::vector<base_corners> measured_base(scene const& sc) {
  std::vector<base_corners> base;
  base.reserve(sc.base.triangles.size());
  for (auto const& t : sc.base.triangles) {
    base_corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      base_vertex const& v = sc.base.vertices[t[k]];
      corners[k] = {v.p, v.n, sc.to_texels(v.u)};
    }
    base.push_back(corners);
  }
  return base;
}

height_map measured_map(scene const& sc) {
  height_map map;
  map.texels = sc.map.texels.data();
  map.width = sc.map.width;
  map.height = sc.map.height;
  map.wrap_u = sc.map.wrap_u;
  map.wrap_v = sc.map.wrap_v;
  map.scale = sc.world_per_sample();
  map.bias = sc.options.bias;
  map.range_low = sc.physical(0.0);
  map.range_high = sc.physical(65535.0);
  return map;
}

error_report measure_error(std::vector<golden::triangle_out> const& out, scene const& sc) {
  return measure_error(world_surface(out, sc), measured_base(sc), measured_map(sc));
}

}  // namespace relievo::tb
