// calculate_new_n: the circuit equals the kernel, one vector a clock, 25 clocks later: for all weights, on unit vectors, on ends a few LSB
// apart, and on opposite ones, which leave little or nothing to normalise.
#include "Vcalculate_new_n.h"
#include "hls/edge/calculate_new_n.hpp"
#include "tests/support/pipeline.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

struct in_only {
  hls::calculate_new_n_in in;
  RELIEVO_FIELDS(in)
};

hls::fixed<formats::weight> weight(std::int64_t k) { return hls::from_raw<formats::weight>(k); }

template <class Shape>
void equals_kernel(Shape shape) {
  pipeline_test<Vcalculate_new_n, in_only>(25, shape, [](in_only const& v) { return hls::calculate_new_n(v.in); });
}

TEST(calculate_new_n, rtl_equals_hls) {
  equals_kernel([](in_only& v, generator&) { v.in.k = weight(raw(v.in.k) % 17); });
}

TEST(calculate_new_n, rtl_equals_hls_on_unit_vectors) {
  equals_kernel([](in_only& v, generator& g) {
    v.in.k = weight(g.chance(2) ? 8 : g.between(0, 16));
    unit_vector(v.in.n1, g);
    unit_vector(v.in.n2, g);
    if (g.chance(2))
      for (int i = 0; i < 3; ++i) near(v.in.n2[i], v.in.n1[i], 5, g);
  });
}

TEST(calculate_new_n, rtl_equals_hls_on_opposite_ends) {
  std::uint64_t zeros = 0, seen = 0;
  pipeline_test<Vcalculate_new_n, in_only>(
      25,
      [](in_only& v, generator& g) {
        v.in.k = weight(g.chance(4) ? g.between(7, 9) : 8);
        unit_vector(v.in.n1, g);
        for (int i = 0; i < 3; ++i) {
          const std::int64_t opposite = -raw(v.in.n1[i]);
          v.in.n2[i] = hls::from_raw<formats::unit>(opposite > 32767 ? 32767 : opposite);
          if (g.chance(2)) near(v.in.n2[i], v.in.n2[i], 1, g);
        }
      },
      [&](in_only const& v) {
        const auto out = hls::calculate_new_n(v.in);
        ++seen;
        zeros += out.zero ? 1 : 0;
        return out;
      });
  EXPECT_GT(zeros, seen / 100);
}

}  // namespace
}  // namespace relievo::test
