// sweep_line: the circuit puts out the kernel's primitives one after the other, under all traffic: every triangle with differences in
// [-1, 1]^3, a share of those in [-3, 3]^3 (all of them from --vectors 23529800 on), all poses of the counterexamples to the paper's rules,
// drawn triangles and slivers. A primitive a clock, from strip to strip and from triangle to triangle. What its moves say gives the
// vertices the kernel's data.
#include "Vsweep_line.h"
#include "tests/support/swept_data.hpp"
#include "tests/support/walked.hpp"

namespace relievo::test {
namespace {

struct vector {
  hls::sweep_line_in in;
  RELIEVO_FIELDS(in)
};
constexpr std::uint64_t latency = 45;
constexpr traffic no_waits = {0, 0, 1, 1};

// Clocks from the first triangle taken to the last primitive out.
std::uint64_t walk(traffic const& t, std::vector<grid_triangle> const& list, std::uint64_t* primitives = nullptr) {
  hls::sweep_line kernel;
  std::size_t at = 0;
  const auto shape = [&](vector& v, generator&) { v.in = corners_of(list[at++ % list.size()]); };
  const auto expected = [&](vector const& v) {
    const std::vector<walked> words = walked_by(kernel, v.in);
    if (primitives != nullptr) *primitives += words.size();
    return words;
  };
  // The registers are drawn first: the list begins anew.
  const std::uint64_t clocks = stream_test<Vsweep_line, vector>(t, shape, expected, {}, list.size(), same_names);
  return clocks;
}

std::vector<grid_triangle> drawn(std::uint64_t count) {
  std::vector<grid_triangle> list;
  generator g = next_generator();
  while (list.size() < count) {
    const std::uint64_t kind = g.below(16);
    if (kind < 8)
      list.push_back(pair_of(g.below(pairs_within(6)), 6));
    else if (kind < 12)
      list.push_back(draw_triangle(g, 12));
    else if (kind < 13)
      list.push_back(draw_triangle(g, 40));
    else
      list.push_back(draw_sliver(g, kind == 15 ? 100 : 8));
  }
  return list;
}

TEST(sweep_line, rtl_equals_hls) {
  for (traffic const& t : all_traffic())
    if (t.latency_high == 1) walk(t, drawn(rtl_vector_count() / 200 + 16));
}
TEST(sweep_line, rtl_equals_hls_on_a_grid) {
  std::vector<grid_triangle> list;
  for (std::uint64_t number = 0; number < pairs_within(1); ++number) list.push_back(pair_of(number, 1));
  generator g = next_generator();
  const std::uint64_t all = pairs_within(3), share = std::min(all, rtl_vector_count() / 20);
  for (std::uint64_t i = 0; i < share; ++i) list.push_back(pair_of(share < all ? g.below(all) : i, 3));
  walk(no_waits, list);
}
TEST(sweep_line, rtl_equals_hls_where_the_paper_fails) {
  std::vector<grid_triangle> list;
  for (grid_triangle const& p : {grid_triangle{{{0, 0, 0}, {4, 0, 0}, {3, 1, 0}}}, grid_triangle{{{0, 0, 0}, {2, 0, 0}, {1, 2, 0}}},
                                 grid_triangle{{{0, 0, 0}, {3, 0, 0}, {1, 3, 0}}}, grid_triangle{{{0, 0, 0}, {2, 2, 0}, {0, 1, 0}}},
                                 grid_triangle{{{2, 0, 0}, {0, 2, 0}, {0, 0, 0}}}, grid_triangle{{{0, 0, 0}, {2, 2, 1}, {1, 0, 2}}},
                                 grid_triangle{{{3, 0, 0}, {0, 0, 3}, {1, 2, 0}}}, grid_triangle{{{5, 7, 2}, {4, 4, 8}, {10, 0, 9}}},
                                 grid_triangle{{{0, 0, 0}, {2, 0, 2}, {1, 1, 0}}}, grid_triangle{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}},
                                 grid_triangle{{{0, 0, 0}, {1, 2, 0}, {0, 1, 1}}}, grid_triangle{{{0, 0, 0}, {5, 3, 1}, {0, 0, 0}}},
                                 grid_triangle{{{0, 0, 0}, {9, 6, 3}, {3, 2, 1}}}, grid_triangle{{{7, -3, 5}, {7, -3, 5}, {7, -3, 5}}}})
    in_all_poses(p, [&](grid_triangle const& pose) { list.push_back(pose); });
  walk({3, 3, 1, 1}, list);
}
TEST(sweep_line, rtl_equals_hls_on_the_longest_edges) {
  std::uint64_t primitives = 0;
  const std::uint64_t clocks = walk(no_waits,
                                    {{{{-32767, 0, 0}, {32767, 1, 0}, {0, 1, 1}}},
                                     {{{32767, 32767, -32767}, {-32767, -32767, 32767}, {-32767, -32766, 32767}}},
                                     {{{-32767, -32767, 0}, {-32767, 32767, 0}, {-32766, 32767, 1}}}},
                                    &primitives);
  EXPECT_EQ(clocks, latency + primitives);
}

// A triangle alone, and one behind the other: as many clocks as primitives, and those to the first one.
TEST(sweep_line, a_primitive_a_clock) {
  generator g = next_generator();
  for (int round = 0; round < 40; ++round) {
    std::uint64_t primitives = 0;
    const std::uint64_t clocks = walk(no_waits, {round % 2 == 0 ? draw_triangle(g, 20) : draw_sliver(g, 60)}, &primitives);
    EXPECT_EQ(clocks, latency + primitives);
  }
  std::uint64_t primitives = 0;
  const std::uint64_t clocks = walk(no_waits, drawn(2000), &primitives);
  EXPECT_EQ(clocks, latency + primitives);
}

TEST(sweep_line, its_moves_give_the_vertices_their_data) {
  hls::sweep_line_of<hls::vertex_steps> kernel;
  generator g = next_generator();
  struct answer {
    bool starts;
    hls::walk_data<hls::vertex_steps> data;
    std::array<hls::vertex_steps, 4> vertices;
  };
  std::deque<answer> answers;
  data_path path;
  const std::vector<grid_triangle> list = drawn(rtl_vector_count() / 400 + 16);
  std::size_t at = 0;
  const auto shape = [&](vector& v, generator&) { v.in = corners_of(list[at++ % list.size()]); };
  const auto expected = [&](vector const& v) {
    grid_triangle p{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) p[i][axis] = static_cast<int>(raw(v.in.p[i][axis]));
    const swept_triangle triangle = draw_swept(g, p);
    const auto data = hls::walk_data_of(triangle.in, hls::difference_vertices(triangle.in));
    kernel.start(v.in, triangle.setup, data);
    std::vector<walked> words;
    do {
      answer a{words.empty(), data, {}};
      hls::vertex_steps vertices[4];
      words.push_back(next_of(kernel, vertices));
      std::copy(vertices, vertices + 4, a.vertices.begin());
      answers.push_back(a);
    } while (!words.back().last);
    return words;
  };
  const auto same = [&](walked const& rtl, walked const& hls) {
    const auto names = same_names(rtl, hls);
    if (!names) return names;
    answer const& a = answers.front();
    if (a.starts) path.start(a.data);
    hls::vertex_steps vertices[4];
    path.step(rtl, vertices);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto result = same_words(vertices[i], a.vertices[i]);
      if (!result) return testing::AssertionFailure() << "vertex " << i << " of " << text_of(rtl.out) << ": " << result.message();
    }
    answers.pop_front();
    return testing::AssertionSuccess();
  };
  stream_test<Vsweep_line, vector>({3, 3, 1, 1}, shape, expected, {}, list.size(), same);
}

}  // namespace
}  // namespace relievo::test
