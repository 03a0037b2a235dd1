// draw: seeded random golden values (words of a format, unit vectors, coordinates) and small random maps with everything that
// units read of a map. For the tests of golden against ideal; hls words are drawn by tests/support/random.hpp.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <random>
#include <vector>

#include "golden/core/rounding.hpp"
#include "golden/surface/memories.hpp"
#include "golden/surface/summed_area_table.hpp"

namespace relievo::test {

using golden::map_regs;
using golden::rounded;
using golden::summed_area_table;
using golden::table_memory;
using golden::texel_memory;

// Random words of a format, and the vectors and maps made of them.
class draw {
 public:
  explicit draw(std::uint64_t seed) : engine_(seed) {}

  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  bool coin() { return integer(0, 1) == 1; }
  template <class F>
  double word(double low, double high) {
    return rounded::at<F>(real(low, high));
  }
  template <class F>
  glm::dvec3 words(double low, double high) {
    return {word<F>(low, high), word<F>(low, high), word<F>(low, high)};
  }
  glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 v(real(-1, 1), real(-1, 1), real(-1, 1));
      if (glm::length(v) > 0.1 && glm::length(v) < 1) return glm::normalize(v);
    }
  }
  static glm::dvec3 to_unit(glm::dvec3 const& v) {
    return {rounded::at<formats::unit>(v.x), rounded::at<formats::unit>(v.y), rounded::at<formats::unit>(v.z)};
  }
  glm::dvec3 unit() { return to_unit(direction()); }

 private:
  std::mt19937_64 engine_;
};

// A random map of 37 x 23 texels, its table and its normals; `smooth` changes by at most 128 a texel along each axis.
class random_map {
 public:
  random_map(draw& d, bool smooth) : regs{37, 23, d.coin(), d.coin()}, texels_(37 * 23) {
    std::vector<int> columns(37), rows(23);
    for (int& c : columns) c = d.integer(0, 64);
    for (int& r : rows) r = d.integer(0, 64);
    const int base = d.integer(0, 65000);
    for (std::size_t y = 0; y < 23; ++y)
      for (std::size_t x = 0; x < 37; ++x)
        texels_[y * 37 + x] = static_cast<std::uint16_t>(smooth ? base + columns[x] + rows[y] + d.integer(0, 64) : d.integer(0, 65535));
    table_ = summed_area_table(texels_.data(), 37, 23);
    for (std::size_t i = 0; i < texels_.size(); ++i) normals_.push_back(d.unit());
  }
  glm::dvec2 coordinate(draw& d) const {
    return {d.word<formats::coordinate>(0, regs.wrap_u ? 37 : 36), d.word<formats::coordinate>(0, regs.wrap_v ? 23 : 22)};
  }
  texel_memory texels() const { return {texels_.data(), regs}; }
  table_memory table() const { return {table_.data(), regs}; }
  glm::dvec3 operator()(int x, int y) const { return normals_[static_cast<std::size_t>(y) * 37 + static_cast<std::size_t>(x)]; }

  map_regs regs;

 private:
  std::vector<std::uint16_t> texels_;
  std::vector<std::uint64_t> table_;
  std::vector<glm::dvec3> normals_;
};

}  // namespace relievo::test
