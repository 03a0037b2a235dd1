// perspective_preparation: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_perspective_preparation, equals_the_unit) {
  for_vectors<hls::perspective_preparation_in>(
      any_word(),
      [](auto const& v) {
        return same_words(through<hls::interpolants>(v, relievo_perspective_preparation), hls::perspective_preparation(v));
      },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
