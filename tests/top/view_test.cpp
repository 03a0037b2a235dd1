// view_test: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::view_test_in, hls::view_test_regs>;

TEST(top_view_test, equals_the_unit) {
  for_vectors<vector>(
      any_word(),
      [](vector const& v) {
        const auto words = through<hls::view_test_out>(v.in, [&](auto& in, auto& out) { relievo_view_test(in, hls::pack(v.regs), out); });
        return same_words(words, hls::view_test(v.in, v.regs));
      },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
