// formats: the one table of fixed-point formats. Widths only, no arithmetic; every model and the RTL package take them from here.
//
//   format<Width, IntegerBits, Signed>: Width bits in all (the sign included), IntegerBits of them before the binary point,
//   Width - IntegerBits after it. A value is raw * 2^-fraction.
//
// The error budget behind each width is in docs/error_budget.md; tests/core/error_budget.cpp holds it against these numbers.
#pragma once
#include <cstdint>

namespace relievo {

template <int Width, int IntegerBits, bool Signed>
struct format {
  static constexpr int width = Width;
  static constexpr int integer_bits = IntegerBits;
  static constexpr int fraction = Width - IntegerBits;
  static constexpr bool is_signed = Signed;
  static_assert(Width >= 1 && Width <= (Signed ? 64 : 63), "a word must fit int64_t");
};

// RELIEVO_FORMATS(X) calls X(name, width, integer bits, signed) for every named format.
// clang-format off
#define RELIEVO_FORMATS(X)                                                                                     \
  /* geometry: the host scales a scene into [-8, 8) and back */                                                \
  X(position,          24,   4, true)   /* world position, 20 fractional bits */                               \
  X(height,            24,   4, true)   /* displacement along the normal, world units; also the bias */        \
  X(unit,              16,   2, true)   /* component of a unit vector, 14 fractional bits: 1.0 is a value */   \
  X(direction,         18,   4, true)   /* component of a vector about to be normalised, 14 fractional bits */ \
  /* maps */                                                                                                   \
  X(coordinate,        25,  14, false)  /* texture coordinate in texels, 11 fractional bits; 8192 is a value */\
  X(fraction, 11, 0, false)             /* place between two texels */                                              \
  X(map_size,          14,  14, false)  /* texels along an axis, 1..8192 */                                    \
  X(texel,             16,  16, false)  /* stored displacement */                                              \
  X(sample,            20,  16, false)  /* filtered displacement, 4 fractional bits */                         \
  X(scale,             24, -12, true)   /* world units per sample, 36 fractional bits */                       \
  X(gradient,          24,   2, true)   /* s/(2 du), s/(2 dv), 22 fractional bits */                           \
  X(shift,              4,   4, false)  /* normal_shift e */                                                   \
  X(table_sum,         40,  40, false)  /* summed-area table word, modulo 2^40 */                              \
  X(rectangle_sum,     45,  41, false)  /* sum over a rectangle, 4 fractional bits once renormalised */        \
  X(bound, 16, 16, true)                /* bound of a rectangle in texels, it may stick out of the map */             \
  X(area, 25, 25, false)                /* texels in a rectangle, 4096 x 4096 at most */                            \
  /* camera */                                                                                                 \
  X(matrix_xy,         26,  12, true)   /* view matrix rows x, y, viewport folded in */                        \
  X(matrix_w,          26,   2, true)   /* view matrix row w */                                                \
  X(offset_xy,         52,  18, true)   /* their translation column, with the fraction of the sum (34) */      \
  X(offset_w,          52,   8, true)   /* (44) */                                                             \
  X(clip,              38,  18, true)   /* x and y before the division, 20 fractional bits */                  \
  X(depth,             28,   8, false)  /* w, 20 fractional bits */                                            \
  X(screen,            22,  14, true)   /* screen position in pixels, 8 sub-pixel bits */                      \
  X(eye,               28,   8, true)   /* the eye's world position, 20 fractional bits */                     \
  /* thresholds */                                                                                             \
  X(normal_threshold,  16,   2, false)  /* difference of components of unit normals */                         \
  X(sum_threshold,     44,  40, false)  /* summed height, sum mode: sample x texel */                          \
  X(average_threshold, 20,  16, false)  /* summed height, average mode: sample */                              \
  X(profile_threshold, 20,  16, false)  /* profile: sample */                                                  \
  X(view_threshold,    24,  16, false)  /* Manhattan distance in pixels */                                     \
  /* sweep */                                                                                                  \
  X(grid,              16,  16, true)   /* position on the voxel grid, any axis */                             \
  X(steps,             16,  16, false)  /* steps of an edge, and places on it */                               \
  X(colour,            16,   1, false)  /* component of a colour, 15 fractional bits: 1.0 is a value */        \
  X(w_mantissa,        24,   0, false)  /* w, normalised to [1/2, 1) */                                        \
  X(inverse_w,         27,   1, false)  /* c: 1/w times the power of two of its block, 26 fractional bits */   \
  X(interp_position,   28,   4, true)   /* P c, 24 fractional bits */                                          \
  X(interp_unit,       28,   2, true)   /* N c, T c (26) */                                                    \
  X(interp_coordinate, 28,  15, true)   /* U c (13) */                                                         \
  X(interp_colour,     28,   2, true)   /* C c (26) */                                                         \
  X(interp_c,          28,   2, true)   /* c (26) */                                                           \
  X(step_position,     48,   8, true)   /* the same with 16 guard bits behind them, modulo 2^48 (40) */        \
  X(step_unit,         48,   6, true)   /* (42) */                                                             \
  X(step_coordinate,   48,  19, true)   /* (29) */                                                             \
  X(step_colour,       48,   6, true)   /* (42) */                                                             \
  X(step_c,            48,   6, true)   /* (42) */                                                             \
  X(correction,        26,   2, false)  /* 1/c, normalised to [1, 2], 24 fractional bits */                    \
  X(clip_depth,        30,  10, true)   /* w before a plane cuts: negative behind the eye (20) */              \
  X(cells,             24,   1, false)  /* cells of the grid a pixel, at most 1 (23) */                        \
  X(kappa,             32,  18, false)  /* cells for each factor e of w, 14 fractional bits */                 \
  X(depth_cells,       40,  26, true)   /* z in cells (14) */                                                  \
  X(ratio,             26,   1, false)  /* place on an edge that is cut, 0 to 1 (25) */                        \
  X(extent,            24,   4, false)  /* largest |displacement| of a triangle, world units (20) */           \
  X(reach,             26,  12, false)  /* clip x or y for each world unit: length of a matrix row (14) */     \
  /* bookkeeping */                                                                                            \
  X(generation,         4,   4, false)  /* generation of an edge, 0..15 */                                     \
  X(weight,             5,   5, false)  /* place of a split on its edge in sixteenths, 0..16; 8 is the middle */      \
  X(index,             32,  32, false)  /* base triangle */
// clang-format on

namespace formats {
#define RELIEVO_FORMAT(name, width, integer_bits, is_signed) using name = format<width, integer_bits, is_signed>;
RELIEVO_FORMATS(RELIEVO_FORMAT)
#undef RELIEVO_FORMAT
}  // namespace formats

// Build parameter: the most intervals that a profile divides an edge into, a power of two from 2 to 16.
#ifndef RELIEVO_PROFILE_INTERVALS
#define RELIEVO_PROFILE_INTERVALS 16
#endif
constexpr int profile_intervals_max = RELIEVO_PROFILE_INTERVALS;
static_assert(profile_intervals_max >= 2 && profile_intervals_max <= 16 && (profile_intervals_max & (profile_intervals_max - 1)) == 0,
              "RELIEVO_PROFILE_INTERVALS is 2, 4, 8 or 16");

}  // namespace relievo
