// displace: the circuit equals the kernel, one vector a clock, ten clocks later.
#include "Vdisplace.h"
#include "hls/surface/displace.hpp"
#include "tests/support/pipeline.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::displace_in, hls::displace_regs>;

TEST(displace, rtl_equals_hls) {
  pipeline_test<Vdisplace, vector>(10, any_word(), [](vector const& v) { return hls::displace(v.in, v.regs); });
}

}  // namespace
}  // namespace relievo::test
