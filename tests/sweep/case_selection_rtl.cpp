// case_selection: the circuit equals the kernel, four clocks later; any corners, triangles, and those of a grid in turn.
#include "Vcase_selection.h"
#include "hls/sweep/case_selection.hpp"
#include "tests/support/pipeline.hpp"
#include "tests/support/sweep_words.hpp"

namespace relievo::test {
namespace {

struct vector {
  hls::case_selection_in in;
  RELIEVO_FIELDS(in)
};
constexpr int latency = 4;

hls::case_selection_out kernel(vector const& v) { return hls::case_selection(v.in); }

// Any corners in any plane of two axes: cases that no triangle has, too.
void any_corners(vector& v, generator& g) {
  hls::remeshing_plane_out& plane = v.in.plane;
  const int s = static_cast<int>(g.below(3)), a = static_cast<int>(g.below(3));
  plane.s = hls::detail::two(s);
  plane.t = hls::detail::two(g.chance(2) ? (s + 1) % 3 : (s + 2) % 3);
  const bool rising = g.chance(2);
  plane.a = hls::detail::two(a);
  plane.b = hls::detail::two(rising ? (a + 1) % 3 : (a + 2) % 3);
  plane.c = hls::detail::two(rising ? (a + 2) % 3 : (a + 1) % 3);
}
void triangles(vector& v, generator& g) { v.in = case_word(draw_grid_triangle(g)); }

TEST(case_selection, rtl_equals_hls) { pipeline_test<Vcase_selection, vector>(latency, any_corners, kernel); }
TEST(case_selection, rtl_equals_hls_on_triangles) {
  std::array<std::uint64_t, 4> kinds{};
  pipeline_test<Vcase_selection, vector>(latency, triangles, [&](vector const& v) {
    const hls::case_selection_out out = kernel(v);
    ++kinds[static_cast<std::size_t>(raw(out.kind))];
    return out;
  });
  for (std::size_t kind = hls::roof_case; kind < kinds.size(); ++kind) EXPECT_GT(kinds[kind], 0U) << kind;
}
TEST(case_selection, rtl_equals_hls_on_a_grid) {
  std::uint64_t number = 0;
  pipeline_test<Vcase_selection, vector>(
      latency, [&](vector& v, generator&) { v.in = case_word(pair_of(number++ % pairs_within(2), 2)); }, kernel);
  EXPECT_GT(number, std::min(pairs_within(2), rtl_vector_count()) - 1);
}

}  // namespace
}  // namespace relievo::test
