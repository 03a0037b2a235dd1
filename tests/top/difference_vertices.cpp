// difference_vertices: the entry point gives the words of the unit, and takes nine words of corners a call.
#include "tests/support/swept_data.hpp"
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_difference_vertices, equals_the_unit) {
  static hls::port<hls::interpolants> corners("corners");
  generator g = next_generator();
  for (std::uint64_t round = 0; round < port_vectors() / 10; ++round) {
    const auto in = draw_swept(g, draw_triangle(g, round % 2 == 0 ? 6 : 16383)).in;
    hls::top::placed_triangle placed;
    placed.plane = in.plane;
    for (int i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis) placed.p[i][axis] = in.p[i][axis];
    write_corners(corners, in);
    const auto words = through<hls::difference_vertices_out>(
        placed, [&](auto& triangles, auto& out) { relievo_difference_vertices(triangles, corners, out); });
    ASSERT_TRUE(corners.empty());
    ASSERT_TRUE(same_words(words, hls::difference_vertices(in))) << describe(in);
  }
}

}  // namespace
}  // namespace relievo::test
