// calculate_new_u: the circuit equals the kernel, one vector a clock, four clocks later, for all weights and on short edges.
#include "Vcalculate_new_u.h"
#include "hls/edge/calculate_new_u.hpp"
#include "tests/support/pipeline.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

struct in_only {
  hls::calculate_new_u_in in;
  RELIEVO_FIELDS(in)
};

void sixteenths(in_only& v, generator&) { v.in.k = hls::from_raw<formats::weight>(raw(v.in.k) % 17); }

template <class Shape>
void equals_kernel(Shape shape) {
  pipeline_test<Vcalculate_new_u, in_only>(4, shape, [](in_only const& v) { return hls::calculate_new_u(v.in); });
}

TEST(calculate_new_u, rtl_equals_hls) { equals_kernel(sixteenths); }

TEST(calculate_new_u, rtl_equals_hls_on_short_edges) {
  equals_kernel([](in_only& v, generator& g) {
    sixteenths(v, g);
    if (g.chance(2)) v.in.k = hls::from_raw<formats::weight>(8);
    for (int i = 0; i < 2; ++i) near(v.in.u2[i], v.in.u1[i], 3, g);
  });
}

}  // namespace
}  // namespace relievo::test
