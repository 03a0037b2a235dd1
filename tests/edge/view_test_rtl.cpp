// view_test: the circuit equals the kernel, four clocks later; anywhere and with lengths within an LSB of the threshold.
#include "Vview_test.h"
#include "hls/edge/view_test.hpp"
#include "tests/support/pipeline.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::view_test_in, hls::view_test_regs>;
constexpr int latency = 4;

hls::view_test_out kernel(vector const& v) { return hls::view_test(v.in, v.regs); }

// The second end lies the threshold and at most an LSB away from the first, where the screen is that large.
void at_the_threshold(vector& v, generator& g) {
  constexpr std::int64_t low = hls::fixed<formats::screen>::min_raw, high = hls::fixed<formats::screen>::max_raw;
  v.in.behind1 = v.in.behind2 = false;
  std::int64_t left = raw(v.regs.threshold) + g.between(-1, 1);
  for (int i = 0; i < 2; ++i) {
    const std::int64_t first = raw(v.in.screen1[i]), most = std::max(high - first, first - low);
    const std::int64_t part = std::max<std::int64_t>(0, std::min(most, i == 0 && left > 1 && left <= most ? g.between(0, left) : left));
    v.in.screen2[i] = hls::from_raw<formats::screen>(first + part <= high ? first + part : first - part);
    left -= part;
  }
}

TEST(view_test, rtl_equals_hls) { pipeline_test<Vview_test, vector>(latency, any_word(), kernel); }
TEST(view_test, rtl_equals_hls_at_the_threshold) {
  std::uint64_t positive = 0, seen = 0;
  pipeline_test<Vview_test, vector>(latency, at_the_threshold, [&](vector const& v) {
    const hls::view_test_out out = kernel(v);
    ++seen;
    positive += out.vt ? 1 : 0;
    return out;
  });
  EXPECT_GT(positive, seen / 20);
  EXPECT_LT(positive, seen / 2) << "equal to the threshold is not above it";
}

}  // namespace
}  // namespace relievo::test
