// write_mesh: an engine's output as .obj, .ply or .glb, by the extension of the path. Vertices are shared where all their words are equal.
//
//   .obj  v (displaced, world), vt, vn, f
//   .ply  binary, little-endian, all numbers double: x y z (displaced, world), nx ny nz, tx ty tz, s t (0..1), px py pz (undisplaced,
//   world);
//         per face vertex_indices and base_triangle; with `raw` also the words of the record as int: raw_x.., raw_nx.., raw_tx.., raw_s
//         raw_t, raw_px.. A comment "relievo world_scale K centre X Y Z map W H clamp|wrap clamp|wrap" says how words and numbers belong
//         together.
//   .glb  POSITION, NORMAL, TANGENT, TEXCOORD_0 (v from the top, as glTF wants), _UNDISPLACED; float; under a node that turns z up into y
//   up Records with `empty` set are left out. Errors: input_error for an unknown extension, an unwritable file, `raw` with values that
//   aren't words.
#pragma once
#include <string>
#include <vector>

#include "golden/edge/triangle.hpp"
#include "tb/host/scene.hpp"

namespace relievo::tb {

// input_error unless the name ends as one of the forms above.
void check_mesh_path(std::string const& path);
void write_mesh(std::string const& path, std::vector<golden::triangle_out> const& triangles, scene const& sc, bool raw = false);

// A mesh in world units, likewise by extension (base meshes as files).
void write_base_mesh(std::string const& path, mesh const& m);

}  // namespace relievo::tb
