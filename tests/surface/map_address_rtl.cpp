// map_address: the circuit equals the kernel, one vector a clock, two clocks later.
#include "Vmap_address.h"
#include "hls/surface/map_address.hpp"
#include "tests/support/map_memories.hpp"
#include "tests/support/pipeline.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

using vector = map_stimulus<hls::map_address_in>;

void within(vector& v, generator& g) {
  // A size that is one stays: a burst keeps its map.
  if (raw(v.map.width) < 1 || raw(v.map.width) > 8192) size_within(v.map.width, 8192, g);
  if (raw(v.map.height) < 1 || raw(v.map.height) > 8192) size_within(v.map.height, 8192, g);
  // A clamped axis stops any coordinate; a wrapped one takes those that the host lets through.
  if (v.map.wrap_u || g.chance(2)) coordinate_within(v.in.u[0], v.map.width, v.map.wrap_u, g);
  if (v.map.wrap_v || g.chance(2)) coordinate_within(v.in.u[1], v.map.height, v.map.wrap_v, g);
}

TEST(map_address, rtl_equals_hls) {
  pipeline_test<Vmap_address, vector>(2, within, [](vector const& v) { return hls::map_address(v.in, v.map); });
}

}  // namespace
}  // namespace relievo::test
