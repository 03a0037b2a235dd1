// walk_data: every vertex that a walk puts out has the data of its name, golden's interpolated_vertex, whichever way it came to it; the
// names are those of a walk of names alone, and so are the additions.
#include "hls/sweep/walk_data.hpp"

#include <gtest/gtest.h>

#include "golden/sweep/interpolated_vertex.hpp"
#include "hls/sweep/sweep_line.hpp"
#include "tests/support/swept_data.hpp"

namespace relievo::test {
namespace {

using data_walk = hls::sweep_line_of<hls::vertex_steps>;

class swept {
 public:
  testing::AssertionResult operator()(generator& g, grid_triangle const& p) {
    const swept_triangle triangle = draw_swept(g, p);
    const auto differences = hls::difference_vertices(triangle.in);
    const auto given = as_golden<golden::difference_vertices_in>(triangle.in);
    golden::interpolated_vertex_in right;
    for (int i = 0; i < 3; ++i) {
      right.p[i] = given.p[i];
      right.corner[i] = given.corner[i];
      for (int end = 0; end < 2; ++end) right.end[i][end] = given.end[i][end];
    }
    right.plane = given.plane;
    right.difference = as_golden<golden::difference_vertices_out>(differences);
    names_.start(corners_of(p));
    walk_.start(corners_of(p), triangle.setup, hls::walk_data_of(triangle.in, differences));
    for (bool last = false; !last;) {
      hls::primitive out, name;
      hls::vertex_steps data[4];
      last = walk_.step(out, data);
      if (names_.step(name) != last || !same_words(out, name))
        return testing::AssertionFailure() << text_of(p) << ": " << text_of(out) << " is named " << text_of(name);
      if (walk_.remeshing().walk().additions() != names_.remeshing().walk().additions()) return testing::AssertionFailure() << "additions";
      for (int i = 0; i < 4; ++i) {
        const bool none = raw(out.v[i].kind) == hls::corner_vertex;  // the missing one too
        if (!none) right.name = as_golden<golden::remeshed_vertex>(out.v[i]);
        const auto result = none ? same_words(data[i], hls::vertex_steps()) : equal_words(data[i], golden::interpolated_vertex(right));
        if (!result)
          return testing::AssertionFailure() << text_of(p) << " vertex " << i << " of " << text_of(out) << ": " << result.message();
        ++kinds_[static_cast<std::size_t>(raw(out.v[i].kind))];
      }
    }
    ++triangles_;
    return testing::AssertionSuccess();
  }
  ~swept() {
    std::printf("%llu triangles, %llu corners, %llu vertices of edges, %llu of the grid\n", static_cast<unsigned long long>(triangles_),
                static_cast<unsigned long long>(kinds_[0]), static_cast<unsigned long long>(kinds_[1]),
                static_cast<unsigned long long>(kinds_[2]));
  }

 private:
  data_walk walk_;
  hls::sweep_line names_;
  std::uint64_t triangles_ = 0;
  std::array<std::uint64_t, 3> kinds_{};
};

TEST(walk_data, triangles_of_a_7x7x7_grid) {
  swept check;
  generator g = next_generator();
  for (std::uint64_t round = 0; round < vector_count() / 50; ++round) ASSERT_TRUE(check(g, pair_of(g.below(pairs_within(6)), 6)));
}

TEST(walk_data, three_main_directions) {
  swept check;
  generator g = next_generator();
  for (std::uint64_t round = 0; round < vector_count() / 50; ++round) {
    const grid_triangle p = pair_of(g.below(pairs_within(6)), 6);
    if (three_main_directions(p)) {
      ASSERT_TRUE(check(g, p));
    }
  }
}

TEST(walk_data, drawn_triangles_and_slivers) {
  swept check;
  generator g = next_generator();
  for (std::uint64_t round = 0; round < vector_count() / 500; ++round) ASSERT_TRUE(check(g, draw_triangle(g, 12)));
  for (std::uint64_t round = 0; round < vector_count() / 5000; ++round) ASSERT_TRUE(check(g, draw_triangle(g, 60)));
  for (std::uint64_t round = 0; round < vector_count() / 2000; ++round) ASSERT_TRUE(check(g, draw_sliver(g, 400)));
  for (std::uint64_t round = 0; round < vector_count() / 200000; ++round) ASSERT_TRUE(check(g, draw_triangle(g, 300)));
  for (std::uint64_t round = 0; round < vector_count() / 100000; ++round) ASSERT_TRUE(check(g, draw_sliver(g, 16383)));
}

// Many columns of few rows each.
TEST(walk_data, the_longest_edges) {
  swept check;
  generator g = next_generator();
  for (std::uint64_t round = 0; round < 1 + vector_count() / 500000; ++round) {
    grid_triangle p = draw_triangle(g, 12);
    const std::size_t axis = g.below(3);
    for (grid_point& corner : p) corner[axis] = static_cast<int>(g.between(0, 16383));
    p[round % 3][axis] = 0;
    p[(round + 1) % 3][axis] = 16383;
    ASSERT_TRUE(check(g, p));
  }
}

TEST(walk_data, in_every_pose) {
  swept check;
  generator g = next_generator();
  for (grid_triangle const& p : {grid_triangle{{{0, 0, 0}, {9, 0, 0}, {4, 3, 0}}}, grid_triangle{{{0, 0, 0}, {9, 5, 0}, {4, 4, 0}}},
                                 grid_triangle{{{0, 0, 0}, {9, 0, 0}, {0, 4, 0}}}, grid_triangle{{{0, 0, 0}, {9, 6, 0}, {0, 4, 0}}},
                                 grid_triangle{{{0, 0, 0}, {5, 3, 1}, {0, 0, 0}}}, grid_triangle{{{5, 7, 2}, {4, 4, 8}, {10, 0, 9}}}})
    in_all_poses(p, [&](grid_triangle const& pose) { ASSERT_TRUE(check(g, pose)); });
}

TEST(walk_data, nothing_is_there_without_a_walk) {
  swept check;
  generator g = next_generator();
  ASSERT_TRUE(check(g, {{{7, -3, 5}, {7, -3, 5}, {7, -3, 5}}}));
}

}  // namespace
}  // namespace relievo::test
