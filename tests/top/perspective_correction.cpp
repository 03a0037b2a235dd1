// perspective_correction: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::perspective_correction_in, hls::perspective_correction_regs>;

TEST(top_perspective_correction, equals_the_unit) {
  for_vectors<vector>(
      any_word(),
      [](vector const& v) {
        const auto words = through<hls::perspective_correction_out>(
            v.in, [&](auto& in, auto& out) { relievo_perspective_correction(in, hls::pack(v.regs), out); });
        return same_words(words, hls::perspective_correction(v.in, v.regs));
      },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
