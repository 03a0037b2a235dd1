// sub_triangle_remeshing: the circuit puts out the kernel's primitives one after the other, under all traffic, sub-triangles of small and
// drawn triangles and three equal corners in turn; a primitive a clock, also from sub-triangle to sub-triangle.
#include "Vsub_triangle_remeshing.h"
#include "tests/support/walked.hpp"

namespace relievo::test {
namespace {

// walk_in_t of rtl/sweep/walk_pkg.sv.
struct walk_in {
  hls::sub_triangle_remeshing_in sub;
  bool ends;
  hls::main_direction_out main[3];
  RELIEVO_FIELDS(sub, ends, main)
};
struct vector {
  walk_in in;
  RELIEVO_FIELDS(in)
};
constexpr std::uint64_t latency = 21;
constexpr traffic no_waits = {0, 0, 1, 1};

// Of three equal corners one word that is no valid sub-triangle.
void add_words(std::vector<walk_in>& list, grid_triangle const& p) {
  const hls::sweep_line_in corners = corners_of(p);
  const hls::sweep_setup setup = hls::set_up(corners);
  for (int i = 0; i < 2; ++i) {
    walk_in word{};
    for (int corner = 0; corner < 3; ++corner) {
      for (int axis = 0; axis < 3; ++axis) word.sub.p[corner][axis] = corners.p[corner][axis];
      word.main[corner] = setup.main[corner];
    }
    word.sub.plane = setup.plane;
    word.sub.sub = setup.cases.sub[i];
    word.ends = i == 1 || !setup.cases.sub[1].valid;
    const bool point = i == 1 && !setup.cases.sub[0].valid && !setup.cases.sub[1].valid;
    if (word.sub.sub.valid || point) list.push_back(word);
  }
}
std::vector<walk_in> drawn(std::uint64_t triangles) {
  std::vector<walk_in> list;
  generator g = next_generator();
  for (std::uint64_t i = 0; i < triangles; ++i) {
    const std::uint64_t kind = g.below(8);
    add_words(list, kind < 4 ? pair_of(g.below(pairs_within(3)), 3) : kind < 6 ? draw_triangle(g, 12) : draw_sliver(g, 40));
    if (g.chance(16)) add_words(list, {{{4, 4, 4}, {4, 4, 4}, {4, 4, 4}}});
  }
  return list;
}

std::uint64_t walk(traffic const& t, std::vector<walk_in> const& list, std::uint64_t& primitives) {
  hls::sub_triangle_remeshing kernel;
  // The bench draws a word that it does not send.
  std::size_t at = list.size() - 1;
  primitives = 0;
  const auto shape = [&](vector& v, generator&) { v.in = list[at++ % list.size()]; };
  const auto expected = [&](vector const& v) {
    std::vector<walked> words;
    const bool point = !v.in.sub.sub.valid;
    if (!point) kernel.start(v.in.sub);
    do {
      walked w{};
      const int column = kernel.column();
      w.sub_last = point || kernel.step(w.out);
      if (point)
        for (int i = 0; i < 3; ++i) w.out.v[i] = hls::detail::corner_of(i);
      w.strip_last = w.sub_last || kernel.column() != column;
      w.last = w.sub_last && v.in.ends;
      words.push_back(w);
    } while (!words.back().sub_last);
    primitives += words.size();
    return words;
  };
  return stream_test<Vsub_triangle_remeshing, vector>(t, shape, expected, {}, list.size(), same_names);
}

TEST(sub_triangle_remeshing, rtl_equals_hls) {
  std::uint64_t primitives = 0;
  for (traffic const& t : all_traffic())
    if (t.latency_high == 1) walk(t, drawn(rtl_vector_count() / 200 + 16), primitives);
  EXPECT_GT(primitives, rtl_vector_count() / 50);
}

TEST(sub_triangle_remeshing, a_primitive_a_clock) {
  std::uint64_t primitives = 0;
  generator g = next_generator();
  for (int round = 0; round < 20; ++round) {
    std::vector<walk_in> list;
    add_words(list, draw_triangle(g, 20));
    const std::uint64_t clocks = walk(no_waits, list, primitives);
    EXPECT_EQ(clocks, latency + primitives);
  }
  const std::uint64_t clocks = walk(no_waits, drawn(1000), primitives);
  EXPECT_EQ(clocks, latency + primitives);
}

}  // namespace
}  // namespace relievo::test
