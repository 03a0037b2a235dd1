#include "tb/host/read_mesh.hpp"

#include "tb/host/files.hpp"
#include "tb/host/input_error.hpp"

namespace relievo::tb {

namespace {

mesh as_base_mesh(loose_mesh loose, std::string const& normals, std::string const& coordinates) {
  if (loose.m.triangles.empty()) throw input_error(loose.m.name + ": no triangles; at least one is needed");
  if (!loose.has_normals) throw input_error(loose.m.name + ": no normals; every vertex needs one (" + normals + ")");
  if (!loose.has_coordinates) throw input_error(loose.m.name + ": no texture coordinates; every vertex needs one (" + coordinates + ")");
  check_base_mesh(loose.m);
  return std::move(loose.m);
}

}  // namespace

mesh read_obj(std::string_view bytes, std::string const& name) { return as_base_mesh(read_any_obj(bytes, name), "vn", "vt"); }
mesh read_ply(std::string_view bytes, std::string const& name) { return as_base_mesh(read_any_ply(bytes, name), "nx ny nz", "s t"); }
mesh read_glb(std::string_view bytes, std::string const& name) { return as_base_mesh(read_any_glb(bytes, name), "NORMAL", "TEXCOORD_0"); }

mesh read_mesh(std::string const& path) {
  const std::string extension = extension_of(path);
  if (extension == "obj") return read_obj(read_bytes(path), path);
  if (extension == "ply") return read_ply(read_bytes(path), path);
  if (extension == "glb") return read_glb(read_bytes(path), path);
  throw input_error(path + ": not a mesh; a file .obj, .ply or .glb, or plane, cylinder, sphere, octahedron, teapot is needed");
}

loose_mesh read_any_mesh(std::string const& path) {
  const std::string extension = extension_of(path);
  if (extension == "obj") return read_any_obj(read_bytes(path), path);
  if (extension == "ply") return read_any_ply(read_bytes(path), path);
  if (extension == "glb") return read_any_glb(read_bytes(path), path);
  throw input_error(path + ": not a mesh; a file .obj, .ply or .glb is needed");
}

}  // namespace relievo::tb
