// tex_coord_test: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_tex_coord_test, equals_the_unit) {
  for_vectors<hls::tex_coord_test_in>(
      any_word(),
      [](auto const& v) { return same_words(through<hls::tex_coord_test_out>(v, relievo_tex_coord_test), hls::tex_coord_test(v)); },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
