// base_meshes: the meshes of our own making. All are counter-clockwise seen from outside, tangents follow u.
//
//   plane:N        N x N quads, 2 N^2 triangles, in z = 0, centred, normal +z, x along u, y along v; the longer side is 2 world units, the
//                  aspect that of the map's samples: max(1, W-1) : max(1, H-1), per axis W or H where it wraps
//   cylinder:N,M   radius 1, height 2 along z, N quads around (N >= 3; u, meant to wrap), M up (v), no caps
//   sphere:N       radius 1, 2N quads around (u the longitude from +x, meant to wrap) and N up (v the latitude, 0 at the south pole); N >=
//   2;
//                  the quads at the poles are triangles whose tips have the u of the quad's middle: the poles are borders
//   octahedron     8 triangles, corners at distance 1; u and v by the octahedral map, +z in the middle, the folds are borders; normals
//   radial teapot:N       Newell's 28 bicubic patches, N x N quads each, u and v 0..1 per patch; z up, spout along +x, standing on z = 0,
//                  scaled so that the body's radius is 1; borders between the patches
// Without a number: plane:8, cylinder:16,4, sphere:8, teapot:4. At most 2^20 triangles.
#pragma once
#include <optional>
#include <string>

#include "tb/host/mesh.hpp"

namespace relievo::tb {

// The mesh that `spec` names, or nothing when `spec` isn't one of the names above (then it is a file's). `samples` is the number of sample
// steps that u, v = 0..1 span (what plane's aspect needs). input_error for a name with unusable numbers.
std::optional<mesh> make_base_mesh(std::string const& spec, glm::dvec2 samples);

// Whether the named mesh closes in u (cylinder, sphere), so that the wrapping address mode is the natural one.
bool wraps_in_u(std::string const& spec);

}  // namespace relievo::tb
