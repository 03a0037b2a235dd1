// welded: an engine's output as one mesh in world units: vertices are shared where all words that go into a file are equal.
#pragma once
#include <vector>

#include "golden/edge/triangle.hpp"
#include "tb/host/scene.hpp"

namespace relievo::tb {

// p := P', n := N', t := T, u := U in 0..1, undisplaced := P, base_triangle; with `raw` the words too, which is refused (input_error) for
// values that are no words, those of the model ideal. Records with `empty` set are left out. The comment says how words and numbers belong
// together.
mesh welded(std::vector<golden::triangle_out> const& triangles, scene const& sc, bool raw = false);

}  // namespace relievo::tb
