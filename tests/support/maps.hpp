// maps: synthetic map memories, as hls reads them and as golden does.
//
//   test_map m(width, height, fill::random, g)   texels, summed-area table and packed normals over the same addresses
//   m.regs(wrap_u, wrap_v)                       its map_regs; m.texels(), m.table(), m.normals() for hls
//   m.golden_texels() ...                        functions of (x, y) for golden, with every address checked
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <stdexcept>
#include <vector>

#include "golden/surface/summed_area_table.hpp"
#include "hls/surface/map_regs.hpp"
#include "tests/support/random.hpp"

namespace relievo::test {

enum class fill { zero, maximum, ramp, checker, random, random_bits, constant };
constexpr fill all_fills[] = {fill::zero, fill::maximum, fill::ramp, fill::checker, fill::random, fill::random_bits, fill::constant};

inline std::vector<std::uint16_t> make_texels(int width, int height, fill how, generator& g) {
  std::vector<std::uint16_t> texels;
  texels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::uint64_t word = 0;
      switch (how) {
        case fill::zero:
          break;
        case fill::maximum:
          word = 65535;
          break;
        case fill::ramp:
          word = static_cast<std::uint64_t>(x * 97 + y * 41);
          break;
        case fill::checker:
          word = (x + y) % 2 != 0 ? 65535 : 0;
          break;
        case fill::random:
          word = g();
          break;
        case fill::random_bits:
          word = g() >> g.below(64);
          break;
        case fill::constant:
          word = 12345;
          break;
      }
      texels.push_back(static_cast<std::uint16_t>(word & 0xffff));
    }
  return texels;
}

class test_map {
 public:
  test_map(int width, int height, fill how, generator& g)
      : width_(width),
        height_(height),
        texels_(make_texels(width, height, how, g)),
        table_(golden::summed_area_table(texels_.data(), width, height)) {
    for (std::size_t i = 0; i < texels_.size(); ++i) normals_.push_back(g() & 0xffffffffffffu);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  hls::map_regs regs(bool wrap_u, bool wrap_v) const {
    return {hls::from_raw<formats::map_size>(width_), hls::from_raw<formats::map_size>(height_), wrap_u, wrap_v};
  }
  hls::texel_memory texels() const { return {texels_.data()}; }
  hls::table_memory table() const { return {table_.data()}; }
  hls::normal_memory normals() const { return {normals_.data()}; }
  std::vector<std::uint16_t> const& words() const { return texels_; }

  int texel(int x, int y) const { return texels_[at(x, y)]; }
  auto golden_texels() const {
    return [this](int x, int y) { return static_cast<double>(texel(x, y)); };
  }
  auto golden_table() const {
    return [this](int x, int y) { return table_[at(x, y)]; };
  }
  auto golden_normals() const {
    return [this](int x, int y) {
      const std::uint64_t word = normals_[at(x, y)];
      glm::dvec3 n;
      for (int i = 0; i < 3; ++i) n[i] = static_cast<std::int16_t>((word >> (16 * i)) & 0xffff) / 16384.0;
      return n;
    };
  }

 private:
  std::size_t at(int x, int y) const {
    if (x < 0 || x >= width_ || y < 0 || y >= height_) throw std::out_of_range("an address outside the map");
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int width_, height_;
  std::vector<std::uint16_t> texels_;
  std::vector<std::uint64_t> table_;
  std::vector<std::uint64_t> normals_;
};

}  // namespace relievo::test
