// main_direction: the circuit equals the kernel, four clocks later; any ends, and edges near a tie.
#include "Vmain_direction.h"
#include "hls/sweep/main_direction.hpp"
#include "tests/support/pipeline.hpp"
#include "tests/support/sweep_words.hpp"

namespace relievo::test {
namespace {

struct vector {
  hls::main_direction_in in;
  RELIEVO_FIELDS(in)
};
constexpr int latency = 4;

hls::main_direction_out kernel(vector const& v) { return hls::main_direction(v.in); }

// Within a step or two of a tie.
void near_ties(vector& v, generator& g) {
  const std::int64_t n = g.between(0, g.chance(2) ? 20 : 32767);
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t from = g.between(-32767, 32767 - n), d = std::max<std::int64_t>(0, n - g.between(0, 2));
    const bool rising = g.chance(2);
    v.in.p[rising ? 0 : 1][axis] = hls::from_raw<formats::grid>(from);
    v.in.p[rising ? 1 : 0][axis] = hls::from_raw<formats::grid>(from + d);
  }
}

TEST(main_direction, rtl_equals_hls) { pipeline_test<Vmain_direction, vector>(latency, any_word(), kernel); }
TEST(main_direction, rtl_equals_hls_near_ties) { pipeline_test<Vmain_direction, vector>(latency, near_ties, kernel); }

}  // namespace
}  // namespace relievo::test
