// map_regs: what goes into a packed normal comes out of it.
#include "hls/surface/map_regs.hpp"

#include <gtest/gtest.h>

#include "tests/support/random.hpp"

namespace relievo::test {
namespace {

TEST(map_regs, every_component_survives_packing) {
  generator g("pack");
  for (std::int64_t word = -32768; word <= 32767; ++word)
    for (int at = 0; at < 3; ++at) {
      hls::fixed<formats::unit> n[3];
      for (auto& c : n) c = hls::from_raw<formats::unit>(g.between(-32768, 32767));
      n[at] = hls::from_raw<formats::unit>(word);
      const std::uint64_t packed = hls::pack_normal(n);
      ASSERT_EQ(packed >> 48, 0u) << "48 bits";
      for (int i = 0; i < 3; ++i) ASSERT_EQ(raw(hls::unpack_normal(packed, i)), raw(n[i])) << word << " at " << at;
    }
}

}  // namespace
}  // namespace relievo::test
