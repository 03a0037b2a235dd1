// sweep_model: the models of the sweep engine behind the face of model.hpp.
//
//   ideal, golden, hls; no circuit yet
//
// Their triangles come as golden::triangle_out, like the edge engine's: N'_s is not the engine's (screen_n 0, away false), the colour is
// not among them; run_hooks::swept has both. barycentric holds the weights in the triangle's piece, made from the vertices' names: those of
// an edge are the same for both its triangles.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "tb/model/model.hpp"

namespace relievo::tb {

// input_error for a model that the sweep engine has not.
std::unique_ptr<model> make_sweep_model(std::string const& name, scene const& sc);

// The weights times 2^60 of a vertex in its piece. Exact on corners; else rounded, towards 0 from the ends of an edge, so that its two
// triangles agree, those of what lies on a side have a 0 there, and the sum is always 2^60.
std::array<std::int64_t, 3> weights_of(golden::remeshed_vertex const& name, glm::dvec3 const (&p)[3],
                                       golden::remeshing_plane_out const& plane);

}  // namespace relievo::tb
