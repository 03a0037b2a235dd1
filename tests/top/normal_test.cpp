// normal_test: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::normal_test_in, hls::normal_test_regs>;

TEST(top_normal_test, equals_the_unit) {
  for_vectors<vector>(
      any_word(),
      [](vector const& v) {
        const auto words =
            through<hls::normal_test_out>(v.in, [&](auto& in, auto& out) { relievo_normal_test(in, hls::pack(v.regs), out); });
        return same_words(words, hls::normal_test(v.in, v.regs));
      },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
