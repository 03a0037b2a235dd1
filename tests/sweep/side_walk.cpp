// side_walk: what holds from clock to clock and from strip to strip.
//   hls equals golden, strip by strip; the registers: roles name registers 0 to 11 or none, and what is still to be read is not
//   overwritten; the left column of a strip is the right one of the strip before, vertex by vertex; an addition a vertex.
#include "hls/sweep/side_walk.hpp"

#include <gtest/gtest.h>

#include "tests/support/remeshed_mesh.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using key_list = std::vector<std::uint64_t>;

// One triangle's strips: what stood on the left and on the right.
struct strip {
  std::int32_t k;
  key_list left, right;
};

std::uint64_t key_of(hls::side_walk const& walk, hls::walk_role role) { return remeshed_mesh::key(walk.registers[role]); }

template <class Observer>
void for_strips(hls::sub_triangle_remeshing& kernel, grid_triangle const& p, Observer observe) {
  const hls::sweep_line_in corners = corners_of(p);
  const hls::sweep_setup setup = hls::set_up(corners);
  hls::sub_triangle_remeshing_in in;
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) in.p[i][axis] = corners.p[i][axis];
  in.plane = setup.plane;
  for (hls::sub_triangle const& sub : setup.cases.sub) {
    if (!sub.valid) continue;
    in.sub = sub;
    kernel.start(in);
    observe(kernel);
  }
}

TEST(side_walk, the_left_column_is_the_right_one_of_the_strip_before) {
  hls::sub_triangle_remeshing kernel;
  generator g = next_generator();
  std::uint64_t columns = 0;
  for (std::uint64_t round = 0; round < vector_count() / 50; ++round) {
    const grid_triangle p = draw_triangle(g, 12);
    for_strips(kernel, p, [&](hls::sub_triangle_remeshing& walking) {
      key_list before;
      bool last = false;
      while (!last) {
        key_list left = {key_of(walking.walk(), hls::role_left)}, right = {key_of(walking.walk(), hls::role_right)};
        const std::int32_t k = walking.column();
        while (!last && walking.column() == k) {
          hls::primitive out;
          const std::uint64_t start = key_of(walking.walk(), hls::role_start);
          last = walking.step(out);
          if (last || walking.column() != k) {
            // The registers are those of the next strip already; its left stands on what was the start.
            if (!last) {
              ASSERT_EQ(key_of(walking.walk(), hls::role_left), start) << text_of(p);
            }
            break;
          }
          if (key_of(walking.walk(), hls::role_left) != left.back()) left.push_back(key_of(walking.walk(), hls::role_left));
          if (key_of(walking.walk(), hls::role_right) != right.back()) right.push_back(key_of(walking.walk(), hls::role_right));
        }
        // The last move of the strip before is not in `before`; the left may go on along the edge.
        for (std::size_t i = 0; i < before.size() && i < left.size(); ++i) ASSERT_EQ(left[i], before[i]) << text_of(p) << " column " << k;
        columns += before.empty() ? 0 : 1;
        before = right;
      }
    });
  }
  EXPECT_GT(columns, vector_count() / 50);
}

TEST(side_walk, roles_name_registers_that_hold_what_was_put_there) {
  hls::sub_triangle_remeshing kernel;
  generator g = next_generator();
  for (std::uint64_t round = 0; round < vector_count() / 100; ++round) {
    const grid_triangle p = draw_triangle(g, 12);
    for_strips(kernel, p, [&](hls::sub_triangle_remeshing& walking) {
      bool last = false;
      while (!last) {
        hls::side_walk const& walk = walking.walk();
        const auto name = [&](hls::walk_role role) { return walk.registers.index(role); };
        for (const auto role : {hls::role_start, hls::role_base, hls::role_left, hls::role_right, hls::role_edge}) {
          ASSERT_GE(name(role), 0);
          ASSERT_LT(name(role), hls::walk_registers_count);
        }
        // Comparison on identity is comparison of indices, as in the paper.
        ASSERT_EQ(name(hls::role_left) == name(hls::role_right), false);
        ASSERT_EQ(name(hls::role_left) == name(hls::role_edge), key_of(walk, hls::role_left) == key_of(walk, hls::role_edge)) << text_of(p);
        ASSERT_EQ(key_of(walk, hls::role_base) >> 50, std::uint64_t{hls::grid_vertex});
        const std::uint64_t edge = key_of(walk, hls::role_edge), start = key_of(walk, hls::role_start), base = key_of(walk, hls::role_base);
        const std::int32_t k = walking.column();
        hls::primitive out;
        last = walking.step(out);
        if (last || walking.column() != k) continue;
        ASSERT_EQ(key_of(walk, hls::role_start), start) << text_of(p);
        ASSERT_EQ(key_of(walk, hls::role_base), base) << text_of(p);
        // E moves on to what was the next one, or stays.
        const auto vertex_used = [&] {
          for (hls::remeshed_vertex const& v : out.v)
            if (remeshed_mesh::key(v) == edge) return true;
          return false;
        };
        if (key_of(walk, hls::role_edge) != edge) {
          ASSERT_TRUE(vertex_used()) << text_of(p) << ": an edge vertex was left out";
        }
      }
    });
  }
}

// A primitive costs an addition a new vertex: at most three a clock, two and a strip's start where the strip changes.
TEST(side_walk, additions_a_clock) {
  hls::sub_triangle_remeshing kernel;
  generator g = next_generator();
  std::array<std::uint64_t, 8> histogram{};
  for (std::uint64_t round = 0; round < vector_count() / 100; ++round) {
    const grid_triangle p = draw_triangle(g, 20);
    for_strips(kernel, p, [&](hls::sub_triangle_remeshing& walking) {
      bool last = false;
      while (!last) {
        const std::int32_t k = walking.column();
        hls::primitive out;
        last = walking.step(out);
        const int additions = walking.walk().additions();
        const bool changed = !last && walking.column() != k;
        ASSERT_LE(additions, 2 + (changed ? 3 : 0)) << text_of(p);
        ++histogram[static_cast<std::size_t>(additions)];
      }
    });
  }
  for (std::size_t i = 0; i < histogram.size(); ++i)
    std::printf("%zu additions: %llu clocks\n", i, static_cast<unsigned long long>(histogram[i]));
}

}  // namespace
}  // namespace relievo::test
