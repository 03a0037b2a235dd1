// teapot_patches: Martin Newell's teapot (1975) as the 28 bicubic Bezier patches that are public figures, without the bottom:
// body and rim 1-12, handle 13-16, spout 17-20, lid 21-28. y is up, the rim's height 0.638, the body's radius 0.567, the spout along +x.
#pragma once

namespace relievo::tb {

constexpr int teapot_points = 269;
constexpr int teapot_patches = 28;

extern double const teapot_point[teapot_points][3];
extern int const teapot_patch[teapot_patches][16];  // rows of four indices into teapot_point, from 0

}  // namespace relievo::tb
