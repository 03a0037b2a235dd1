// remeshing_plane: the circuit equals the kernel, ten clocks later; any corners, and primary edges.
#include "Vremeshing_plane.h"
#include "hls/sweep/remeshing_plane.hpp"
#include "tests/support/pipeline.hpp"
#include "tests/support/sweep_words.hpp"

namespace relievo::test {
namespace {

struct vector {
  hls::remeshing_plane_in in;
  RELIEVO_FIELDS(in)
};
constexpr int latency = 10;

hls::remeshing_plane_out kernel(vector const& v) { return hls::remeshing_plane(v.in); }

// An edge that is not primary has an answer too.
void any_corners(vector& v, generator& g) {
  v.in.edge = hls::detail::two(static_cast<int>(g.below(3)));
  v.in.axis = hls::detail::two(static_cast<int>(g.below(3)));
}
void triangles(vector& v, generator& g) { v.in = plane_word(draw_grid_triangle(g)); }

TEST(remeshing_plane, rtl_equals_hls) { pipeline_test<Vremeshing_plane, vector>(latency, any_corners, kernel); }
TEST(remeshing_plane, rtl_equals_hls_on_triangles) { pipeline_test<Vremeshing_plane, vector>(latency, triangles, kernel); }

}  // namespace
}  // namespace relievo::test
