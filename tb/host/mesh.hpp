// mesh: a triangle mesh in world units, as read or made, before it is brought into the formats.
//
//   p, n, t   position, unit normal, unit tangent (along growing u, orthogonal to n)
//   u         texture coordinate as in files: 0..1, v = 0 at the bottom row of the map
//   Edge i of a triangle runs from its vertex i to vertex (i + 1) % 3, counter-clockwise seen from outside.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace relievo::tb {

struct base_vertex {
  glm::dvec3 p{0.0}, n{0.0}, t{0.0};
  glm::dvec2 u{0.0};
};

// One word per field of a vertex as the engine put it out; only in .ply files written with --raw.
struct raw_vertex {
  std::array<std::int32_t, 3> displaced_p{}, displaced_n{}, t{}, p{};
  std::array<std::int32_t, 2> u{};
};

struct mesh {
  std::string name;  // the file or the name of the generator, for messages
  std::vector<base_vertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool has_tangents = false;  // base_vertex::t is given; otherwise complete_tangents makes it from u
  bool planar = false;        // is_planar, filled in by make_base_mesh and make_scene

  // What our own .ply files carry besides; empty when the file had none.
  std::vector<glm::dvec3> undisplaced;       // per vertex: the point on the base surface
  std::vector<std::uint32_t> base_triangle;  // per triangle
  std::vector<raw_vertex> raw;               // per vertex
  std::vector<std::string> comments;         // the file's comment lines
};

// Whether all positions lie in one plane (to 1e-9 of the extent) and every normal is that plane's.
bool is_planar(mesh const& m);

// World units per texel along u and v: lengths of dP/du and dP/dv over `texels_per_unit` (texels that u = 0..1 spans), averaged over the
// triangles by their area. Exact for an affine parametrisation. Nothing when no triangle has an area in u and in p; 1 along an axis that
// spans no texels.
std::optional<glm::dvec2> estimate_texel_size(mesh const& m, glm::dvec2 texels_per_unit);

// Fills t from u where has_tangents is false: dP/du of the triangles around a vertex, weighted by area, averaged over all vertices of one
// class (vertex_class[i] numbers those that agree in P, N and U), made orthogonal to n. Where u says nothing (no area), any direction
// orthogonal to n. Where has_tangents is true, makes t orthogonal to n. has_tangents is true afterwards.
// input_error for a mirrored parametrisation, where n x t would not point along growing v, in more than a quarter of a connected piece;
// single triangles that are turned over are left to be folds of a displaced mesh.
void complete_tangents(mesh& m, std::vector<std::uint32_t> const& vertex_class);

// Refuses what no engine can take, with a line that names the mesh, the field and the vertex or triangle: no triangles, coordinates that
// are not finite or above 1e9, normals of zero length, indices out of range, a triangle with a repeated index, an edge that more than two
// triangles use or two in the same direction (vertices count as one where P, N and U agree). Normalises the normals.
void check_base_mesh(mesh& m);

}  // namespace relievo::tb
