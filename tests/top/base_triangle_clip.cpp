// base_triangle_clip: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::base_triangle_clip_in, hls::base_triangle_clip_regs>;

TEST(top_base_triangle_clip, equals_the_unit) {
  for_vectors<vector>(
      any_word(),
      [](vector const& v) {
        const auto words = through<hls::base_triangle_clip_out>(
            v.in, [&](auto& in, auto& out) { relievo_base_triangle_clip(in, hls::pack(v.regs), out); });
        return same_words(words, hls::base_triangle_clip(v.in, v.regs));
      },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
