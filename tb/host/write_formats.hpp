// write_formats: a mesh in world units as the bytes of each file format. What the mesh lacks (tangents, undisplaced positions, base
// triangles, raw words) is left out.
#pragma once
#include <string>

#include "tb/host/mesh.hpp"

namespace relievo::tb {

std::string obj_text(mesh const& m);
std::string ply_bytes(mesh const& m);
// `name` stands in the message when the format cannot hold the mesh.
std::string glb_bytes(mesh const& m, std::string const& name);

}  // namespace relievo::tb
