// summed_area_table: the entry point builds the table of one map a call, and starts afresh with the next.
#include <memory>

#include "tests/support/map_cases.hpp"
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_summed_area_table, builds_every_map) {
  const auto in = std::make_unique<hls::port<hls::top::texel_word>>("in");
  const auto out = std::make_unique<hls::port<hls::top::table_word>>("out");
  for_maps([&](test_map const& map, hls::map_regs const& regs) {
    if (map.words().size() > 4096) return;  // more than a port of the simulation holds at once
    for (const std::uint16_t texel : map.words()) in->write(hls::pack(hls::top::texel_word{hls::from_raw<formats::texel>(texel)}));
    relievo_summed_area_table(*in, hls::pack(regs), *out);
    ASSERT_TRUE(in->empty());
    ASSERT_EQ(static_cast<std::size_t>(out->size()), map.words().size());
    for (std::size_t i = 0; i < map.words().size(); ++i)
      ASSERT_EQ(static_cast<std::uint64_t>(raw(hls::unpack<hls::top::table_word>(out->read()).sum)), map.table().words[i]) << "texel " << i;
  });
}

}  // namespace
}  // namespace relievo::test
