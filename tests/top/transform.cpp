// transform: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::transform_in, hls::transform_regs>;

TEST(top_transform, equals_the_unit) {
  for_vectors<vector>(
      any_word(),
      [](vector const& v) {
        const auto words = through<hls::transform_out>(v.in, [&](auto& in, auto& out) { relievo_transform(in, hls::pack(v.regs), out); });
        return same_words(words, hls::transform(v.in, v.regs));
      },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
