// side_walk: what holds from clock to clock and from strip to strip.
//   hls equals golden, strip by strip; the registers: roles name registers 0 to 11 or none, and what is still to be read is not
//   overwritten; the left column of a strip is the right one of the strip before, vertex by vertex; an addition a vertex.
#include "hls/sweep/side_walk.hpp"

#include <gtest/gtest.h>

#include "golden/sweep/sub_triangle_remeshing.hpp"
#include "tests/support/remeshed_mesh.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using key_list = std::vector<std::uint64_t>;

std::uint64_t key_of(hls::side_walk const& walk, hls::walk_role role) { return remeshed_mesh::key(walk.registers[role]); }

// observe(kernel, in) for each sub-triangle, started.
template <class Observer>
void for_sub_triangles(hls::sub_triangle_remeshing& kernel, grid_triangle const& p, Observer observe) {
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
    observe(kernel, in);
  }
}

// Strip by strip: the primitives, and where the side edge stands afterwards.
testing::AssertionResult strips_equal_golden(hls::sub_triangle_remeshing& walking, hls::sub_triangle_remeshing_in const& words) {
  const auto in = as_golden<golden::sub_triangle_remeshing_in>(words);
  golden::sub_triangle const& sub = in.sub;
  const golden::sweep_frame frame = golden::frame_of(in.plane, sub.backward);
  const int start = sub.backward ? in.plane.b : in.plane.a, end = sub.backward ? in.plane.a : in.plane.b;
  const auto k0 = static_cast<std::int64_t>(sub.k0), k1 = static_cast<std::int64_t>(sub.k1);
  const std::vector<golden::place> primary = golden::edge_places(in, frame, start, end);
  std::vector<golden::place> side = golden::edge_places(in, frame, sub.from, sub.to), end_edge;
  for (golden::place& place : side) place.on_last_edge = true;
  if (sub.corner_list) {
    const std::vector<golden::place> vertical = golden::edge_places(in, frame, start, sub.from);
    side.insert(side.begin(), vertical.begin(), vertical.end() - 1);
  }
  for (golden::place& place : side) place.column = std::min(place.column, k1 - 1);
  side.back().column = k1;
  if (sub.ends_on_edge) end_edge = golden::edge_places(in, frame, sub.end_corner, sub.to);

  std::size_t at = sub.starts_at_corner ? 1 : 0;
  for (std::int64_t k = k0; k < k1; ++k) {
    const bool first = k == k0, last = k + 1 == k1;
    std::vector<golden::primitive> right;
    const auto foot = [&](std::int64_t column) { return primary[static_cast<std::size_t>(column - primary.front().column)]; };
    at = golden::side_walk(frame,
                           {k, foot(k), foot(k + 1), first && sub.starts_at_corner, last && sub.pointed, last && sub.ends_on_edge, at},
                           side, end_edge, right);
    for (std::size_t i = 0; i < right.size(); ++i) {
      if (walking.column() != k) return testing::AssertionFailure() << "column " << k << " is left after " << i << " primitives";
      hls::primitive out;
      const bool done = walking.step(out);
      const auto result = equal_words(out, right[i]);
      if (!result) return testing::AssertionFailure() << "column " << k << " primitive " << i << ": " << result.message();
      if (done != (last && i + 1 == right.size())) return testing::AssertionFailure() << "column " << k << ": the end is elsewhere";
    }
    if (walking.column() != k + 1) return testing::AssertionFailure() << "column " << k << " is not left";
    const auto edge = equal_words(walking.walk().registers[hls::role_edge], side[at].vertex);
    if (!edge) return testing::AssertionFailure() << "after column " << k << " E is another: " << edge.message();
  }
  return testing::AssertionSuccess();
}

TEST(side_walk, hls_equals_golden_strip_by_strip) {
  hls::sub_triangle_remeshing kernel;
  generator g = next_generator();
  for (std::uint64_t round = 0; round < vector_count() / 50; ++round) {
    const grid_triangle p = round % 8 == 0 ? draw_sliver(g, 200) : draw_triangle(g, round % 8 == 1 ? 30 : 8);
    for_sub_triangles(kernel, p, [&](hls::sub_triangle_remeshing& walking, hls::sub_triangle_remeshing_in const& in) {
      ASSERT_TRUE(strips_equal_golden(walking, in)) << text_of(p);
    });
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(side_walk, the_left_column_is_the_right_one_of_the_strip_before) {
  hls::sub_triangle_remeshing kernel;
  generator g = next_generator();
  std::uint64_t columns = 0;
  for (std::uint64_t round = 0; round < vector_count() / 50; ++round) {
    const grid_triangle p = draw_triangle(g, 12);
    for_sub_triangles(kernel, p, [&](hls::sub_triangle_remeshing& walking, hls::sub_triangle_remeshing_in const&) {
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
    for_sub_triangles(kernel, p, [&](hls::sub_triangle_remeshing& walking, hls::sub_triangle_remeshing_in const&) {
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
    for_sub_triangles(kernel, p, [&](hls::sub_triangle_remeshing& walking, hls::sub_triangle_remeshing_in const&) {
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
