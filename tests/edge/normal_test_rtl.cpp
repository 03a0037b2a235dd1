// normal_test: the circuit equals the kernel, three clocks later; anywhere and with every difference within an LSB of the threshold.
#include "Vnormal_test.h"
#include "hls/edge/normal_test.hpp"
#include "tests/support/pipeline.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::normal_test_in, hls::normal_test_regs>;
constexpr int latency = 3;

hls::normal_test_out kernel(vector const& v) { return hls::normal_test(v.in, v.regs); }

// pipeline_test keeps the threshold for a burst and draws the normals around it.
void at_the_threshold(vector& v, generator& g) {
  const std::int64_t threshold = raw(v.regs.threshold);
  const std::int64_t room = threshold + 1 > 32767 ? 0 : 32767 - threshold - 1;
  for (int i = 0; i < 3; ++i) {
    v.in.n12[i] = hls::from_raw<formats::unit>(g.between(-room, room));
    for (auto* n : {&v.in.n1[i], &v.in.n2[i]}) {
      const std::int64_t slack = g.chance(8) ? g.between(-1, 1) : 0;
      const std::int64_t word = raw(v.in.n12[i]) + (g.chance(2) ? 1 : -1) * (threshold + slack);
      *n = hls::from_raw<formats::unit>(word > 32767 ? 32767 : word < -32768 ? -32768 : word);
    }
  }
}

TEST(normal_test, rtl_equals_hls) { pipeline_test<Vnormal_test, vector>(latency, any_word(), kernel); }
TEST(normal_test, rtl_equals_hls_at_the_threshold) {
  std::uint64_t positive = 0, seen = 0;
  pipeline_test<Vnormal_test, vector>(latency, at_the_threshold, [&](vector const& v) {
    const hls::normal_test_out out = kernel(v);
    ++seen;
    positive += out.nt ? 1 : 0;
    return out;
  });
  EXPECT_GT(positive, seen / 20);
  EXPECT_LT(positive, seen * 19 / 20);
}

}  // namespace
}  // namespace relievo::test
