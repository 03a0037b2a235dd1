// read_mesh: triangle meshes from files: .obj (tinyobjloader), .glb (tinygltf), .ply (own reader: see read_ply.cpp for why).
//
//   Polygons become fans of triangles. Positions, normals and texture coordinates are required, tangents are taken where the format has
//   them
//   (.ply tx ty tz, .glb TANGENT) and otherwise made later by complete_tangents. Everything is checked by check_base_mesh.
//   .glb is y up with v = 0 at the top; it comes in z up (x, -z, y) with v = 0 at the bottom, and so it is written.
//   A .ply of ours as base mesh gives the second pass of Figure 11c: P := P', N := N', T := T made orthogonal to N'.
//   Errors: input_error, one line with the file's name and the field.
#pragma once
#include <string>
#include <string_view>

#include "tb/host/mesh.hpp"

namespace relievo::tb {

// By the extension of `path`.
mesh read_mesh(std::string const& path);

// The same from memory; `name` stands in the messages.
mesh read_obj(std::string_view bytes, std::string const& name);
mesh read_ply(std::string_view bytes, std::string const& name);
mesh read_glb(std::string_view bytes, std::string const& name);

// For tools that look at meshes which need not be usable as base meshes (relievo check): the file as it is, indices in range and numbers
// finite, but without check_base_mesh; has_normals and has_coordinates say whether n and u mean anything.
struct loose_mesh {
  mesh m;
  bool has_normals = false;
  bool has_coordinates = false;
};
loose_mesh read_any_mesh(std::string const& path);
loose_mesh read_any_obj(std::string_view bytes, std::string const& name);
loose_mesh read_any_ply(std::string_view bytes, std::string const& name);
loose_mesh read_any_glb(std::string_view bytes, std::string const& name);

}  // namespace relievo::tb
