// normalize: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_normalize, equals_the_unit) {
  for_vectors<hls::normalize_in>(
      any_word(), [](auto const& v) { return same_words(through<hls::normalize_out>(v, relievo_normalize), hls::normalize(v)); },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
