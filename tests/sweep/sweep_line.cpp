// sweep_line: hls equals golden, primitive by primitive; every result is a mesh of its triangle (tests/support/remeshed_mesh.hpp).
//   Every triangle with differences in [-6, 6]^3, 4,826,809 of them: here a seeded share, one in vector_count() / 10, and all with three
//   main directions; all of them from --vectors 48268090 on. The counterexamples to the paper's rules by name, in all 288 poses.
#include "hls/sweep/sweep_line.hpp"

#include <gtest/gtest.h>

#include "golden/sweep/sweep_line.hpp"
#include "tests/support/remeshed_mesh.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

bool same(hls::remeshed_vertex const& a, golden::remeshed_vertex const& b) {
  const auto is = [](std::int64_t word, double value) { return static_cast<double>(word) == value; };
  return raw(a.kind) == b.kind && raw(a.number) == b.number && is(raw(a.i), b.i) && is(raw(a.s), b.s) && is(raw(a.t), b.t);
}
// Ten million primitives: equal_words only says where they differ.
bool same(hls::primitive const& a, golden::primitive const& b) {
  return a.quad == b.quad && same(a.v[0], b.v[0]) && same(a.v[1], b.v[1]) && same(a.v[2], b.v[2]) && same(a.v[3], b.v[3]);
}

testing::AssertionResult equals_golden(primitive_list const& list, grid_triangle const& p) {
  const std::vector<golden::primitive> right = golden::sweep_line(as_golden<golden::sweep_line_in>(corners_of(p)));
  for (std::size_t i = 0; i < list.size() && i < right.size(); ++i) {
    if (same(list[i], right[i])) continue;
    const auto result = equal_words(list[i], right[i]);
    return testing::AssertionFailure() << text_of(p) << " primitive " << i << ": " << result.message() << text_of(list);
  }
  if (list.size() == right.size()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << text_of(p) << ": " << list.size() << " primitives, golden " << right.size() << text_of(list);
}

// One triangle after the other through one kernel, as in an engine.
class swept {
 public:
  testing::AssertionResult operator()(grid_triangle const& p) {
    remeshed_mesh mesh(p);
    remesh(kernel_, p, list_, mesh.most_primitives());
    const auto whole = mesh.check(list_);
    if (!whole) return whole;
    mesh.count_steps(list_, steps_);
    ++triangles_;
    primitives_ += list_.size();
    return equals_golden(list_, p);
  }
  primitive_list const& list() const { return list_; }
  step_histogram const& steps() const { return steps_; }
  void print(char const* what) const {
    std::printf("%s: %llu triangles, %llu primitives\n", what, static_cast<unsigned long long>(triangles_),
                static_cast<unsigned long long>(primitives_));
  }

 private:
  hls::sweep_line kernel_;
  primitive_list list_;
  step_histogram steps_;
  std::uint64_t triangles_ = 0, primitives_ = 0;
};

void in_every_pose(grid_triangle const& p) {
  swept check;
  bool good = true;
  in_all_poses(p, [&](grid_triangle const& pose) {
    if (!good) return;
    const auto result = check(pose);
    good = static_cast<bool>(result);
    EXPECT_TRUE(result);
  });
}

// ---- where the paper's rules fail ---------------------------------------------------------------------------------------

TEST(sweep_line, drags_to_an_edge_vertex_on_the_base_s_own_grid_point) { in_every_pose({{{0, 0, 0}, {4, 0, 0}, {3, 1, 0}}}); }
TEST(sweep_line, climbs_along_a_steep_edge) { in_every_pose({{{0, 0, 0}, {2, 0, 0}, {1, 2, 0}}}); }
TEST(sweep_line, keeps_edge_vertices_off_the_inner_line) { in_every_pose({{{0, 0, 0}, {3, 0, 0}, {1, 3, 0}}}); }
TEST(sweep_line, ends_in_a_fan) { in_every_pose({{{0, 0, 0}, {2, 2, 0}, {0, 1, 0}}}); }
TEST(sweep_line, the_base_goes_down_too) { in_every_pose({{{2, 0, 0}, {0, 2, 0}, {0, 0, 0}}}); }
TEST(sweep_line, compares_rows_not_coordinates) { in_every_pose({{{0, 0, 0}, {2, 2, 1}, {1, 0, 2}}}); }
TEST(sweep_line, a_double_step_takes_the_right_base) { in_every_pose({{{3, 0, 0}, {0, 0, 3}, {1, 2, 0}}}); }
TEST(sweep_line, two_double_steps_in_a_row) { in_every_pose({{{5, 7, 2}, {4, 4, 8}, {10, 0, 9}}}); }
TEST(sweep_line, the_diagonal_that_leaves_no_triangle_empty) { in_every_pose({{{0, 0, 0}, {2, 0, 2}, {1, 1, 0}}}); }
TEST(sweep_line, a_vertical_side_edge) { in_every_pose({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}}); }
TEST(sweep_line, double_steps_with_two_main_directions) { in_every_pose({{{0, 0, 0}, {1, 2, 0}, {0, 1, 1}}}); }

// ---- what is no triangle ------------------------------------------------------------------------------------------------

TEST(sweep_line, all_corners_equal_are_the_one_triangle) {
  swept check;
  ASSERT_TRUE(check({{{7, -3, 5}, {7, -3, 5}, {7, -3, 5}}}));
  ASSERT_EQ(check.list().size(), 1U);
  EXPECT_EQ(text_of(check.list()[0]), "triangle P0 P1 P2");
}
TEST(sweep_line, corners_on_one_line) {
  in_every_pose({{{0, 0, 0}, {4, 2, 0}, {2, 1, 0}}});
  in_every_pose({{{0, 0, 0}, {9, 6, 3}, {3, 2, 1}}});
  in_every_pose({{{0, 0, 0}, {0, 0, 7}, {0, 0, 2}}});
}
// The edge between them has no length, but two ends: a triangle of no area closes it.
TEST(sweep_line, two_corners_equal) {
  in_every_pose({{{0, 0, 0}, {5, 3, 1}, {0, 0, 0}}});
  in_every_pose({{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}});
  in_every_pose({{{0, 0, 0}, {4, 4, 4}, {0, 0, 0}}});
}
TEST(sweep_line, the_smallest_triangles) {
  in_every_pose({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  in_every_pose({{{0, 0, 0}, {1, 1, 0}, {0, 1, 1}}});
}

// ---- all of them --------------------------------------------------------------------------------------------------------

constexpr int grid = 6;

TEST(sweep_line, triangles_of_a_7x7x7_grid) {
  swept check;
  generator g = next_generator();
  const std::uint64_t share = vector_count() / 10, all = pairs_within(grid);
  for (std::uint64_t i = 0; i < std::min(share, all); ++i) ASSERT_TRUE(check(pair_of(share < all ? g.below(all) : i, grid)));
  check.print(share < all ? "drawn" : "all");
}

TEST(sweep_line, triangles_of_a_7x7x7_grid_with_three_main_directions) {
  swept check;
  const std::uint64_t stride = std::max<std::uint64_t>(1000000 / std::max<std::uint64_t>(vector_count(), 1), 1);
  std::uint64_t found = 0;
  for (std::uint64_t number = 0; number < pairs_within(grid); ++number) {
    const grid_triangle p = pair_of(number, grid);
    if (three_main_directions(p) && found++ % stride == 0) {
      ASSERT_TRUE(check(p));
    }
  }
  EXPECT_EQ(found, 468384U);
  check.print("three main directions");
}

// ---- larger ones --------------------------------------------------------------------------------------------------------

TEST(sweep_line, drawn_triangles_and_slivers) {
  swept check;
  generator g = next_generator();
  for (std::uint64_t round = 0; round < vector_count() / 200; ++round) ASSERT_TRUE(check(draw_triangle(g, 12)));
  for (std::uint64_t round = 0; round < vector_count() / 2000; ++round) ASSERT_TRUE(check(draw_triangle(g, 60)));
  for (std::uint64_t round = 0; round < vector_count() / 1000; ++round) ASSERT_TRUE(check(draw_sliver(g, 400)));
  for (std::uint64_t round = 0; round < vector_count() / 100000; ++round) ASSERT_TRUE(check(draw_triangle(g, 400)));
  for (std::uint64_t round = 0; round < vector_count() / 100000; ++round) ASSERT_TRUE(check(draw_sliver(g, 16383)));
  check.print("drawn");
  // An edge has its vertices where the interpolation has them: at most root 3 apart. Inside, the grid's own distances.
  step_histogram const& steps = check.steps();
  std::printf("steps on edges: %llu to 1, %llu to root 2, %llu to root 3; inside: %llu along s, %llu along t, %llu diagonals\n",
              static_cast<unsigned long long>(steps.on_an_edge[0]), static_cast<unsigned long long>(steps.on_an_edge[1]),
              static_cast<unsigned long long>(steps.on_an_edge[2]), static_cast<unsigned long long>(steps.inside[0]),
              static_cast<unsigned long long>(steps.inside[1]), static_cast<unsigned long long>(steps.inside[2]));
  EXPECT_EQ(steps.on_an_edge[3], 0U);
  EXPECT_EQ(steps.inside[3], 0U);
}

TEST(sweep_line, the_longest_edges_of_the_format) {
  swept check;
  EXPECT_TRUE(check({{{-32767, 0, 0}, {32767, 1, 0}, {0, 1, 1}}}));
  EXPECT_TRUE(check({{{32767, 32767, -32767}, {-32767, -32767, 32767}, {-32767, -32766, 32767}}}));
}

// The paper: "slightly more than two additions" a quad. Counted in the registers, a strip's and a walk's start included.
TEST(sweep_line, vector_additions_a_quad) {
  generator g = next_generator();
  std::uint64_t additions = 0, quads = 0, primitives = 0, triangles = 0;
  double most = 0;
  for (std::uint64_t round = 0; round < 20 + vector_count() / 5000; ++round) {
    const grid_triangle p = draw_triangle(g, round % 4 == 0 ? 300 : 100);
    std::uint64_t here = 0, quads_here = 0, primitives_here = 0;
    hls::sweep_line kernel;
    kernel.start(corners_of(p));
    here += static_cast<std::uint64_t>(kernel.remeshing().walk().additions());
    bool last = false;
    const std::uint64_t bound = static_cast<std::uint64_t>(remeshed_mesh(p).most_primitives());
    while (!last && primitives_here <= bound) {
      hls::primitive out;
      last = kernel.step(out);
      here += static_cast<std::uint64_t>(kernel.remeshing().walk().additions());
      quads_here += out.quad ? 1 : 0;
      ++primitives_here;
    }
    if (quads_here <= 1000) continue;
    additions += here;
    quads += quads_here;
    primitives += primitives_here;
    ++triangles;
    most = std::max(most, static_cast<double>(here) / static_cast<double>(quads_here));
  }
  ASSERT_GT(triangles, 5U);
  std::printf("%llu triangles over 1,000 quads: %.3f vector additions a quad, at most %.3f; %.3f clocks a quad\n",
              static_cast<unsigned long long>(triangles), static_cast<double>(additions) / static_cast<double>(quads), most,
              static_cast<double>(primitives) / static_cast<double>(quads));
  EXPECT_LE(static_cast<double>(additions) / static_cast<double>(quads), 2.3);
}

}  // namespace
}  // namespace relievo::test
