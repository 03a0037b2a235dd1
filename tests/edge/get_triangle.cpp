// get_triangle: hls equals golden on every combination of flags and generations; base, inserted and known vertices.
#include "hls/edge/get_triangle.hpp"

#include <gtest/gtest.h>

#include "golden/core/rounding.hpp"
#include "golden/edge/get_triangle.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

// 6 flags of the vertices, 3 of the edges, one edge's generation and the limit: 2^17; the other edges' generations follow.
TEST(get_triangle, every_combination) {
  for (std::uint32_t word = 0; word < (1u << 17); ++word) {
    hls::triangle t{};
    const auto limit = hls::from_raw<formats::generation>(word >> 13);
    for (std::uint32_t i = 0; i < 3; ++i) {
      t.v[i].displaced = (word >> i & 1) != 0;
      t.v[i].transformed = (word >> (3 + i) & 1) != 0;
      t.settled[i] = (word >> (6 + i) & 1) != 0;
      t.generation[i] = hls::from_raw<formats::generation>(((word >> 9) + 5 * i) & 15);
    }
    const auto out = hls::get_triangle(t, limit);
    const auto golden_t = as_golden<golden::triangle>(t);
    ASSERT_TRUE(equal_words(out, golden::get_triangle<golden::rounded>(golden_t, static_cast<double>(raw(limit))))) << describe(t);
    for (int i = 0; i < 3; ++i) {
      ASSERT_EQ(out.new_surface[i], !t.v[i].displaced);
      ASSERT_EQ(out.new_normal[i], !t.v[i].transformed);
      ASSERT_EQ(out.settled[i], t.settled[i] || raw(t.generation[i]) >= raw(limit)) << "generation " << raw(t.generation[i]);
    }
  }
}

}  // namespace
}  // namespace relievo::test
