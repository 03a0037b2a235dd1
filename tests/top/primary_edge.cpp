// primary_edge: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_primary_edge, equals_the_unit) {
  for_vectors<hls::primary_edge_in>(
      [](hls::primary_edge_in& in, generator& g) {
        for (hls::two_bits& axis : in.axis) axis = hls::detail::two(static_cast<int>(g.below(3)));
      },
      [](auto const& v) { return same_words(through<hls::primary_edge_out>(v, relievo_primary_edge), hls::primary_edge(v)); },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
