// sub_triangle_remeshing: hls equals golden, primitive by primitive; both sides of the line s = C.s list the same vertices; columns.
#include "hls/sweep/sub_triangle_remeshing.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "golden/sweep/sub_triangle_remeshing.hpp"
#include "tests/support/remeshed_mesh.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

hls::sub_triangle_remeshing_in input_of(grid_triangle const& p, hls::sweep_setup const& setup, int sub) {
  const hls::sweep_line_in corners = corners_of(p);
  hls::sub_triangle_remeshing_in in;
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) in.p[i][axis] = corners.p[i][axis];
  in.plane = setup.plane;
  in.sub = setup.cases.sub[sub];
  return in;
}

// Both sub-triangles; the second goes on where the first one ended.
std::array<primitive_list, 2> remeshed(hls::sub_triangle_remeshing& kernel, grid_triangle const& p, hls::sweep_setup const& setup) {
  std::array<primitive_list, 2> lists;
  for (int sub = 0; sub < 2; ++sub) {
    if (!setup.cases.sub[sub].valid) continue;
    kernel.start(input_of(p, setup, sub));
    bool last = false;
    while (!last) {
      lists[static_cast<std::size_t>(sub)].emplace_back();
      last = kernel.step(lists[static_cast<std::size_t>(sub)].back());
    }
  }
  return lists;
}

testing::AssertionResult equals_golden(primitive_list const& list, hls::sub_triangle_remeshing_in const& in) {
  const std::vector<golden::primitive> right = golden::sub_triangle_remeshing(as_golden<golden::sub_triangle_remeshing_in>(in));
  for (std::size_t i = 0; i < list.size() && i < right.size(); ++i) {
    const auto result = equal_words(list[i], right[i]);
    if (!result) return testing::AssertionFailure() << "primitive " << i << ": " << result.message() << text_of(list);
  }
  if (list.size() == right.size()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << list.size() << " primitives, golden " << right.size() << text_of(list);
}

TEST(sub_triangle_remeshing, hls_equals_golden) {
  hls::sub_triangle_remeshing kernel;
  generator g = next_generator();
  for (std::uint64_t round = 0; round < vector_count() / 50; ++round) {
    const grid_triangle p = round % 8 == 0 ? draw_sliver(g, 200) : draw_triangle(g, round % 8 == 1 ? 30 : 8);
    const hls::sweep_setup setup = hls::set_up(corners_of(p));
    const auto lists = remeshed(kernel, p, setup);
    for (int sub = 0; sub < 2; ++sub) {
      if (!setup.cases.sub[sub].valid) continue;
      ASSERT_TRUE(equals_golden(lists[static_cast<std::size_t>(sub)], input_of(p, setup, sub))) << text_of(p) << " part " << sub;
    }
  }
}

// Directed edges that a part of the triangle uses once: its border.
std::set<std::pair<std::uint64_t, std::uint64_t>> border_of(primitive_list const& list) {
  std::set<std::pair<std::uint64_t, std::uint64_t>> border;
  const auto add = [&border](hls::remeshed_vertex const& from, hls::remeshed_vertex const& to) {
    const std::uint64_t a = remeshed_mesh::key(from), b = remeshed_mesh::key(to);
    if (border.erase({b, a}) == 0) border.insert({a, b});
  };
  for (hls::primitive const& q : list)
    for (int i = 0, n = q.quad ? 4 : 3; i < n; ++i) add(q.v[i], q.v[i + 1 == n ? 0 : i + 1]);
  return border;
}

TEST(sub_triangle_remeshing, both_sides_of_the_inner_line_list_the_same_vertices) {
  hls::sub_triangle_remeshing kernel;
  generator g = next_generator();
  std::uint64_t lines = 0;
  for (std::uint64_t round = 0; round < vector_count() / 50; ++round) {
    const grid_triangle p = draw_triangle(g, 12);
    const hls::sweep_setup setup = hls::set_up(corners_of(p));
    if (!setup.cases.sub[0].valid || !setup.cases.sub[1].valid) continue;
    const auto lists = remeshed(kernel, p, setup);
    const auto left = border_of(lists[0]), right = border_of(lists[1]);
    // What the border of one part has the other way round in that of the other is the line; it leads from C to the primary edge.
    std::map<std::uint64_t, std::uint64_t> line;
    for (auto const& edge : left)
      if (right.count({edge.second, edge.first}) != 0) line[edge.first] = edge.second;
    std::uint64_t at = remeshed_mesh::key(hls::detail::corner_of(static_cast<int>(raw(setup.plane.c))));
    std::size_t length = 0;
    if (line.count(at) == 0)
      for (auto& edge : std::exchange(line, {})) line[edge.second] = edge.first;
    while (line.count(at) != 0 && length <= line.size()) {
      at = line[at];
      ++length;
    }
    ASSERT_EQ(length, line.size()) << text_of(p) << text_of(lists[0]) << "\n--" << text_of(lists[1]);
    ASSERT_GT(length, 0U) << text_of(p);
    const std::uint64_t primary = static_cast<std::uint64_t>(hls::detail::after(static_cast<int>(raw(setup.plane.c))));
    ASSERT_EQ(at >> 48, (std::uint64_t{hls::edge_vertex} << 2 | primary)) << text_of(p) << ": the line does not end on the primary edge";
    ++lines;
  }
  EXPECT_GT(lines, vector_count() / 200);
}

}  // namespace
}  // namespace relievo::test
