// memories: the read-only map memories of a scene as the golden engine sees them.
//
//   texels      W*H displacement samples, row 0 is v = 0, x fastest
//   table       W*H words of the exclusive summed-area table (word (x, y) is SAT(x+1, y+1)); may be null when sht is off
//   normal_map  registers of the normal-map builder; golden computes the map's normals when they are asked for
//
// Units take a memory as a function of integer addresses, so that tests can put a formula in its place.
#pragma once
#include <cstddef>
#include <cstdint>

#include "golden/surface/map_regs.hpp"
#include "golden/surface/normal_map.hpp"

namespace relievo {
namespace golden {

struct memories {
  std::uint16_t const* texels = nullptr;
  std::uint64_t const* table = nullptr;
  normal_map_regs normal_map;
};

class texel_memory {
 public:
  texel_memory(std::uint16_t const* texels, map_regs const& map) : texels_(texels), width_(static_cast<std::size_t>(map.width)) {}
  double operator()(int x, int y) const { return texels_[static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x)]; }

 private:
  std::uint16_t const* texels_;
  std::size_t width_;
};

class table_memory {
 public:
  table_memory(std::uint64_t const* words, map_regs const& map) : words_(words), width_(static_cast<std::size_t>(map.width)) {}
  // The stored word (x, y), which is SAT(x+1, y+1).
  std::uint64_t operator()(int x, int y) const { return words_[static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x)]; }

 private:
  std::uint64_t const* words_;
  std::size_t width_;
};

// The memory of the normal map, computed from its definition.
template <class Rounding, class Texels>
class normal_memory {
 public:
  normal_memory(Texels const& texels, map_regs const& map, normal_map_regs const& regs) : texels_(texels), map_(map), regs_(regs) {}
  glm::dvec3 operator()(int x, int y) const { return golden::normal_map<Rounding>({x, y}, map_, regs_, texels_).n; }

 private:
  Texels texels_;
  map_regs map_;
  normal_map_regs regs_;
};

}  // namespace golden
}  // namespace relievo
