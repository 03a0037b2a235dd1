// divide: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

hls::top::divide_out unit(hls::top::divide_in const& in) {
  hls::top::divide_out out;
  out.clipped = false;
  out.quotient = hls::divide<formats::screen>(in.numerator, in.denominator, out.clipped);
  return out;
}

TEST(top_divide, equals_the_unit) {
  for_vectors<hls::top::divide_in>(
      any_word(), [](auto const& v) { return same_words(through<hls::top::divide_out>(v, relievo_divide), unit(v)); }, port_vectors());
}

}  // namespace
}  // namespace relievo::test
