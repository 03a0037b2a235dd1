// displace: the entry point gives the words of the unit.
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::displace_in, hls::displace_regs>;

TEST(top_displace, equals_the_unit) {
  for_vectors<vector>(
      any_word(),
      [](vector const& v) {
        const auto words = through<hls::displace_out>(v.in, [&](auto& in, auto& out) { relievo_displace(in, hls::pack(v.regs), out); });
        return same_words(words, hls::displace(v.in, v.regs));
      },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
