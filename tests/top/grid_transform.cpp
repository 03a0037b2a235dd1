// grid_transform: the entry point gives the words of the unit.
#include <array>

#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::grid_transform_in, hls::grid_transform_regs>;

TEST(top_grid_transform, equals_the_unit) {
  generator g("z");
  std::array<std::int64_t, hls::z_table_words> z{};
  for (std::int64_t& word : z) word = random_word<formats::depth_cells>(draw::mixed, g);
  for_vectors<vector>(
      any_word(),
      [&z](vector const& v) {
        const auto words = through<hls::grid_transform_out>(
            v.in, [&](auto& in, auto& out) { relievo_grid_transform(in, hls::pack(v.regs), z.data(), out); });
        return same_words(words, hls::grid_transform(v.in, v.regs, {z.data()}));
      },
      port_vectors());
}

}  // namespace
}  // namespace relievo::test
