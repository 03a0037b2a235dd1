// tex_coord_test: the circuit equals the kernel, two clocks later; anywhere and at the midpoints of edges about a texel long.
#include "Vtex_coord_test.h"
#include "hls/edge/calculate_new_u.hpp"
#include "hls/edge/tex_coord_test.hpp"
#include "tests/support/pipeline.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

struct vector {
  hls::tex_coord_test_in in;
  RELIEVO_FIELDS(in)
};
constexpr int latency = 2;

hls::tex_coord_test_out kernel(vector const& v) { return hls::tex_coord_test(v.in); }

void at_midpoint(vector& v, generator& g) {
  for (int i = 0; i < 2; ++i) near(v.in.u2[i], v.in.u1[i], g.chance(2) ? 3000 : 6000, g);
  const auto middle = hls::calculate_new_u({{v.in.u1[0], v.in.u1[1]}, {v.in.u2[0], v.in.u2[1]}, hls::from_raw<formats::weight>(8)});
  for (int i = 0; i < 2; ++i) v.in.u12[i] = middle.u[i];
}

TEST(tex_coord_test, rtl_equals_hls) { pipeline_test<Vtex_coord_test, vector>(latency, any_word(), kernel); }
TEST(tex_coord_test, rtl_equals_hls_at_midpoints) {
  std::uint64_t positive = 0, seen = 0;
  pipeline_test<Vtex_coord_test, vector>(latency, at_midpoint, [&](vector const& v) {
    const hls::tex_coord_test_out out = kernel(v);
    ++seen;
    positive += out.ct ? 1 : 0;
    return out;
  });
  EXPECT_GT(positive, seen / 20);
  EXPECT_LT(positive, seen * 19 / 20);
}

}  // namespace
}  // namespace relievo::test
