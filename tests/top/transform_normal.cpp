// transform_normal: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::transform_normal_in, hls::transform_normal_regs>;

TEST(top_transform_normal, equals_the_unit) {
  for_vectors<vector>(
      any_word(),
      [](vector const& v) {
        const auto words =
            through<hls::transform_normal_out>(v.in, [&](auto& in, auto& out) { relievo_transform_normal(in, hls::pack(v.regs), out); });
        return same_words(words, hls::transform_normal(v.in, v.regs));
      },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
