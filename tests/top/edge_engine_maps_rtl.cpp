// edge_engine_maps: its clocks: how long after its first texel is offered a map is taken and built. What it builds and refuses is tested
// through the buses (tests/top/edge_engine_rtl_maps.cpp).
#include <gtest/gtest.h>

#include <vector>

#include "Vedge_engine_maps.h"
#include "hls/surface/map_regs.hpp"
#include "hls/surface/normal_map.hpp"
#include "tb/cosim/ports.hpp"
#include "tests/support/clocked_model.hpp"

namespace relievo::test {
namespace {

// Of the builders, as their tests assert them; of the way to them, once a map.
constexpr int table_latency = 7, normal_latency = 32, first_texel = 2;

// Clocks from the first texel offered: in which texels were taken, and words came.
struct times {
  std::vector<int> taken, table, normals;
  int busy_until = 0;  // the last after which a part of the map was inside
};

times build(clocked_model<Vedge_engine_maps>& m, int width, int height, bool wrap_v) {
  hls::map_regs regs{};
  regs.width = hls::from_raw<formats::map_size>(width);
  regs.height = hls::from_raw<formats::map_size>(height);
  regs.wrap_v = wrap_v;
  tb::put(m->regs_i, regs);
  times t;
  const auto texels = static_cast<std::size_t>(width * height);
  for (int clock = 0; clock < 2000 && (t.normals.size() < texels || m->busy_o); ++clock) {
    m->in_valid_i = t.taken.size() < texels;
    m->in_i = static_cast<SData>(clock);
    m->in_last_i = t.taken.size() + 1 == texels;
    m.settle();
    if (m->in_valid_i && m->in_ready_o) t.taken.push_back(clock);
    if (m->table_valid_o) t.table.push_back(clock);
    if (m->normal_valid_o) t.normals.push_back(clock);
    m.clock();
    EXPECT_EQ(m->error_o, 0);
    if (m->busy_o) t.busy_until = clock;
  }
  return t;
}

TEST(edge_engine_maps, a_texel_a_clock_and_words_when_the_builders_have_them) {
  clocked_model<Vedge_engine_maps> m;
  hls::normal_map_regs normal_regs{};
  tb::put(m->normal_regs_i, normal_regs);
  m->close_i = m->stop_i = m->in_valid_i = m->in_last_i = 0;
  m->table_ready_i = m->normal_ready_i = 1;
  m.reset();
  for (const int width : {1, 2, 5, 40})
    for (const int height : {1, 2, 7})
      for (const bool wrap_v : {false, true}) {
        const times t = build(m, width, height, wrap_v);
        const int texels = width * height;
        ASSERT_EQ(t.taken.size(), static_cast<std::size_t>(texels));
        ASSERT_EQ(t.table.size(), t.taken.size());
        ASSERT_EQ(t.normals.size(), t.taken.size());
        for (int i = 0; i < texels; ++i) {
          const auto n = static_cast<std::size_t>(i);
          ASSERT_EQ(t.taken[n], first_texel + i) << width << " x " << height << ", texel " << i;
          ASSERT_EQ(t.table[n], first_texel + i + table_latency) << width << " x " << height << ", word " << i;
        }
        hls::map_regs regs{};
        regs.width = hls::from_raw<formats::map_size>(width);
        regs.height = hls::from_raw<formats::map_size>(height);
        regs.wrap_v = wrap_v;
        const int steps = width * (height + hls::normal_map<>::flush_rows(regs));
        ASSERT_EQ(t.normals.back(), first_texel + steps - 1 + normal_latency) << width << " x " << height << ", wrap " << wrap_v;
        // Two clocks later the next map may begin.
        ASSERT_EQ(t.busy_until, t.normals.back()) << width << " x " << height;
      }
}

}  // namespace
}  // namespace relievo::test
