// base_sides: what lies at each side of each base triangle.
//
//   Side k runs from vertex k to vertex (k + 1) % 3. Two sides are one (shared) when their ends agree in P, N, T and U, U modulo the
//   wrap. A side that shares nothing is a border where another one has its positions, or where it has no length itself; else it is
//   the mesh's boundary.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "golden/edge/triangle.hpp"
#include "golden/surface/map_regs.hpp"

namespace relievo::tb {

enum class side_kind : std::uint8_t { shared, boundary, border };

class base_sides {
 public:
  struct place {
    std::uint32_t triangle;
    std::uint8_t side;
    bool forward;  // runs from the lower-numbered end to the higher; sides of a group with equal flags run alike
  };

  base_sides(std::vector<golden::triangle> const& base, golden::map_regs const& map);

  side_kind kind(std::size_t triangle, std::size_t side) const { return kinds_[3 * triangle + side]; }
  std::vector<std::vector<place>> const& groups() const { return groups_; }

 private:
  std::vector<side_kind> kinds_;
  std::vector<std::vector<place>> groups_;  // shared sides only
};

// U with the far end of a wrapped axis brought to 0.
inline glm::dvec2 unwrapped(glm::dvec2 u, golden::map_regs const& map) {
  if (map.wrap_u && u.x == map.width) u.x = 0.0;
  if (map.wrap_v && u.y == map.height) u.y = 0.0;
  return u;
}

}  // namespace relievo::tb
