// sweep_registers: the registers of the sweep engine from a scene whose map, displacement and camera are set.
//
//   near, far    world units times world_scale 2^row_exponent, rounded to depth. near has to lie beyond w_min, before which transform takes
//                all for behind the eye, by more than a cut vertex is off its plane; and at 2^-20 max(W, H), for base_triangle_clip. far
//                is held at the format's end: no vertex of a scene lies beyond
//   kappa        1 / ln(1 + 2 g tan(fov / 2) / H), g = --grid;  the grid may have at most 16,383 steps from near to far
//   reach, d_scale   lengths of the matrix's rows, rounded up, and 2^-13 more for normals that are rounded themselves
//   d_max        of the highest and the lowest sample of the map
//   Errors: input_error, naming the option.
#pragma once
#include "tb/host/scene.hpp"

namespace relievo::tb {

constexpr int most_steps = 16383;

void set_sweep(scene& sc, map_extremes const& extremes);

}  // namespace relievo::tb
