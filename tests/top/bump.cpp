// bump: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_bump, equals_the_unit) {
  for_vectors<hls::bump_in>(
      any_word(), [](auto const& v) { return same_words(through<hls::bump_out>(v, relievo_bump), hls::bump(v)); }, port_vectors());
}

}  // namespace
}  // namespace relievo::test
