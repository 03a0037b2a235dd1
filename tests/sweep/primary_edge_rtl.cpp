// primary_edge: the circuit equals the kernel, three clocks later; any words, and triangles.
#include "Vprimary_edge.h"
#include "hls/sweep/primary_edge.hpp"
#include "tests/support/pipeline.hpp"
#include "tests/support/sweep_words.hpp"

namespace relievo::test {
namespace {

struct vector {
  hls::primary_edge_in in;
  RELIEVO_FIELDS(in)
};
constexpr int latency = 3;

hls::primary_edge_out kernel(vector const& v) { return hls::primary_edge(v.in); }

// Axes and lengths that are not those of the corners too: often no edge is primary then.
void any_axes(vector& v, generator& g) {
  for (int i = 0; i < 3; ++i) v.in.axis[i] = hls::detail::two(static_cast<int>(g.below(3)));
}
void triangles(vector& v, generator& g) { v.in = edges_word(draw_grid_triangle(g)); }

TEST(primary_edge, rtl_equals_hls) { pipeline_test<Vprimary_edge, vector>(latency, any_axes, kernel); }
TEST(primary_edge, rtl_equals_hls_on_triangles) { pipeline_test<Vprimary_edge, vector>(latency, triangles, kernel); }

}  // namespace
}  // namespace relievo::test
