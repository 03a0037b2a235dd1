// main_direction: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_main_direction, equals_the_unit) {
  for_vectors<hls::main_direction_in>(
      any_word(),
      [](auto const& v) { return same_words(through<hls::main_direction_out>(v, relievo_main_direction), hls::main_direction(v)); },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
