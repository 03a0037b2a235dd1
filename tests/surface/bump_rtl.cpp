// verilate: Vbump
// verilate: Vbump_3 Clocks=3
// bump: the circuit equals the kernel, one vector a clock, 31 clocks later, or one in three clocks and 34 later: on any words, on unit
// vectors, and where little is left to normalise.
#include "Vbump.h"
#include "Vbump_3.h"
#include "hls/surface/bump.hpp"
#include "tests/support/pipeline.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

struct in_only {
  hls::bump_in in;
  RELIEVO_FIELDS(in)
};

template <class Shape>
void equals_kernel(Shape shape) {
  pipeline_test<Vbump, in_only>(31, shape, [](in_only const& v) { return hls::bump(v.in); });
}

void unit_vectors(in_only& v, generator& g) {
  unit_vector(v.in.n, g);
  unit_vector(v.in.t, g);
  unit_vector(v.in.m, g);
}

TEST(bump, rtl_equals_hls) { equals_kernel(any_word()); }
TEST(bump, rtl_equals_hls_on_unit_vectors) { equals_kernel(unit_vectors); }
TEST(bump, rtl_equals_hls_in_three_clocks) {
  const auto kernel = [](in_only const& v) { return hls::bump(v.in); };
  pipeline_test<Vbump_3, in_only, 3>(34, any_word(), kernel);
  pipeline_test<Vbump_3, in_only, 3>(34, unit_vectors, kernel);
}

// Opposite contributions, so that what is normalised is small or nothing.
TEST(bump, rtl_equals_hls_where_little_is_left) {
  std::uint64_t zeros = 0;
  pipeline_test<Vbump, in_only>(
      31,
      [](in_only& v, generator& g) {
        unit_vector(v.in.n, g);
        for (int i = 0; i < 3; ++i) near(v.in.t[i], v.in.n[i], 3, g);
        near(v.in.m[0], hls::from_raw<formats::unit>(-raw(v.in.m[2]) == 32768 ? 32767 : -raw(v.in.m[2])), 2, g);
      },
      [&](in_only const& v) {
        const auto out = hls::bump(v.in);
        zeros += out.zero ? 1 : 0;
        return out;
      });
  EXPECT_GT(zeros, 0U);
}

}  // namespace
}  // namespace relievo::test
