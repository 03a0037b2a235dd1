// near_clip: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::near_clip_in, hls::near_clip_regs>;

TEST(top_near_clip, equals_the_unit) {
  for_vectors<vector>(
      any_word(),
      [](vector const& v) {
        const auto words = through<hls::near_clip_out>(v.in, [&](auto& in, auto& out) { relievo_near_clip(in, hls::pack(v.regs), out); });
        return same_words(words, hls::near_clip(v.in, v.regs));
      },
      port_vectors() / 10);
}

}  // namespace
}  // namespace relievo::test
