// normal_map: the entry point builds the normals of one map a call, and starts afresh with the next.
#include <memory>

#include "tests/support/map_cases.hpp"
#include "tests/top/through.hpp"

namespace relievo::test {
namespace {

TEST(top_normal_map, builds_every_map) {
  const auto in = std::make_unique<hls::port<hls::top::texel_word>>("in");
  const auto out = std::make_unique<hls::port<hls::normal_map_out>>("out");
  generator g("normals");
  for_maps([&](test_map const& map, hls::map_regs const& regs) {
    if (map.words().size() > 4096) return;  // more than a port of the simulation holds at once
    hls::normal_map_regs normal_regs{};
    draw_vector(normal_regs, draw::magnitude, g);
    for (const std::uint16_t texel : map.words()) in->write(hls::pack(hls::top::texel_word{hls::from_raw<formats::texel>(texel)}));
    relievo_normal_map(*in, hls::pack(regs), hls::pack(normal_regs), *out);
    ASSERT_TRUE(in->empty());
    ASSERT_EQ(static_cast<std::size_t>(out->size()), map.words().size());

    const auto builder = std::make_unique<hls::normal_map<512>>();
    const std::size_t steps = map.words().size() + static_cast<std::size_t>(map.width() * hls::normal_map<512>::flush_rows(regs));
    for (std::size_t i = 0; i < steps; ++i) {
      hls::normal_map_out expected{};
      if (builder->step(hls::from_raw<formats::texel>(i < map.words().size() ? map.words()[i] : 0), regs, normal_regs, expected)) {
        ASSERT_TRUE(same_words(hls::unpack<hls::normal_map_out>(out->read()), expected)) << "step " << i;
      }
    }
    ASSERT_TRUE(out->empty());
  });
}

}  // namespace
}  // namespace relievo::test
