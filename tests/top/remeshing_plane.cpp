// remeshing_plane: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_remeshing_plane, equals_the_unit) {
  for_vectors<hls::remeshing_plane_in>(
      [](hls::remeshing_plane_in& in, generator& g) {
        in.edge = hls::detail::two(static_cast<int>(g.below(3)));
        in.axis = hls::detail::two(static_cast<int>(g.below(3)));
      },
      [](auto const& v) { return same_words(through<hls::remeshing_plane_out>(v, relievo_remeshing_plane), hls::remeshing_plane(v)); },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
