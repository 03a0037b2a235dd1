// verilate: Vhighlight_test
// verilate: Vhighlight_test_3 Clocks=3
// highlight_test: the circuit equals the kernel, four clocks later, or in three clocks seven later; anywhere and with products that end
// next to the threshold.
#include "Vhighlight_test.h"
#include "Vhighlight_test_3.h"
#include "hls/edge/highlight_test.hpp"
#include "tests/support/pipeline.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::highlight_test_in, hls::highlight_test_regs>;
constexpr int latency = 4;

hls::highlight_test_out kernel(vector const& v) { return hls::highlight_test(v.in, v.regs); }

std::int64_t limited(std::int64_t word) { return word > 32767 ? 32767 : word < -32768 ? -32768 : word; }

// The normals lie where N' . H is the threshold or next to it, H an axis of 0.5 and words of an LSB: the last bits of the products decide.
// What pipeline_test keeps for a burst is shaped once and stays as it is.
void at_the_threshold(vector& v, generator& g) {
  if (raw(v.regs.half_vector[0]) != 8192 || std::abs(raw(v.regs.half_vector[1])) > 1 || std::abs(raw(v.regs.half_vector[2])) > 1) {
    v.regs.threshold = hls::from_raw<formats::unit>(raw(v.regs.threshold) / 4);
    const std::int64_t h[3] = {8192, g.between(-1, 1), g.between(-1, 1)};
    for (int i = 0; i < 3; ++i) v.regs.half_vector[i] = hls::from_raw<formats::unit>(h[i]);
  }
  for (auto* n : {v.in.n1, v.in.n2, v.in.n12}) {
    n[0] = hls::from_raw<formats::unit>(limited(2 * raw(v.regs.threshold) - (g.chance(4) ? 1 : 0)));
    for (int i = 1; i < 3; ++i) n[i] = hls::from_raw<formats::unit>(g.between(-1, 1));
  }
}

TEST(highlight_test, rtl_equals_hls) { pipeline_test<Vhighlight_test, vector>(latency, any_word(), kernel); }
TEST(highlight_test, rtl_equals_hls_in_three_clocks) { pipeline_test<Vhighlight_test_3, vector, 3>(7, at_the_threshold, kernel); }
TEST(highlight_test, rtl_equals_hls_at_the_threshold) {
  std::uint64_t positive = 0, seen = 0;
  pipeline_test<Vhighlight_test, vector>(latency, at_the_threshold, [&](vector const& v) {
    const hls::highlight_test_out out = kernel(v);
    ++seen;
    positive += out.ht ? 1 : 0;
    return out;
  });
  EXPECT_GT(positive, seen / 20);
  EXPECT_LT(positive, seen * 19 / 20);
}

}  // namespace
}  // namespace relievo::test
