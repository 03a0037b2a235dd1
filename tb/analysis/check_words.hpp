// check_words: the check by what a file or a circuit gives: words, without exact weights.
//
//   Topology: vertices are one where P, T and U agree (U modulo the wrap), or, without P, where P' does. Triangles with two corners
//   that are one are collapsed and left out, which closes the mesh over them (both neighbours of a collapsed edge see it collapse).
//
//   Which side of its base triangle an edge lies on, and areas, are known within rounding only. Each of up to 15 generations rounds
//   once, by at most half an LSB a component, and interpolation hands the error of the ends on without enlarging it; half an LSB more
//   covers a base mesh that itself wasn't quantised. So a vertex is off its exact place by at most
//     d = (15 + 1) / 2 LSB = 8 LSB a component            (2^-8 texel in U)
//   and a vertex lies on a side when its distance to it is at most d times the root of the number of components.
//   Areas in U, twice, |.|1 the sum of the components' sizes:
//     one triangle with edges e1, e2, each off by at most 2 d a component:  2 d (|e1|1 + |e2|1) + 8 d^2
//     the sum over a base triangle: vertices inside cancel, so only those on the sides count. Shoelace with errors on m boundary
//     vertices: sum of |e_i x (X_{i+1} - X_{i-1})| + |e_i x e_{i+1}|  <=  2 d (perimeter)1 + 2 m d^2
//   A hole below that bound is still found, by its open edges.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "tb/analysis/check.hpp"

namespace relievo::tb {

inline constexpr double rounding_lsbs = 8.0;

struct words_vertex {
  glm::dvec3 p{0.0};  // P
  glm::dvec3 t{0.0};
  glm::dvec2 u{0.0};  // texels
  glm::dvec3 displaced_p{0.0}, displaced_n{0.0};
};

struct words_mesh {
  std::vector<words_vertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> base_triangle;  // per triangle, or empty
  bool has_p = false;
  bool has_t = false;
  bool has_u = false;
  bool has_n = false;
  golden::map_regs map;  // sizes and wraps of U; both axes of size 1 and wrapping when unknown
  double position_lsb = 0.0;
  double coordinate_lsb = 0.0;
};

// base: P, N, T, U of the base triangles in the same units, or empty.
void check_words(words_mesh const& m, std::vector<golden::triangle> const& base, check_options const& options, check_report& report);

// The part about areas in U alone (check_areas_in_u.cpp).
void check_areas_in_u(words_mesh const& m, std::vector<golden::triangle> const& base, check_options const& options, check_report& report);

words_mesh words_of(std::vector<golden::triangle_out> const& out, golden::map_regs const& map);

}  // namespace relievo::tb
