// edge_engine_input: its clocks: a record goes on exactly one clock after it was taken, one every other clock; what is wrong with it is
// said a clock after it left, together with the end of the engine's input. What it lets through and refuses is tested through the buses
// (tests/top/edge_engine_rtl_errors.cpp).
#include <gtest/gtest.h>

#include <vector>

#include "Vedge_engine_input.h"
#include "hls/top/top.hpp"
#include "tb/cosim/edge_engine_driver.hpp"
#include "tb/cosim/ports.hpp"
#include "tb/cosim/ports_of_lanes.hpp"
#include "tests/support/clocked_model.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using code = tb::edge_engine_code;
// As a port has it.
constexpr int number(code c) { return static_cast<int>(c); }

// Coordinates up to 100 texels on both axes.
constexpr std::int64_t limit = std::int64_t(100) << formats::coordinate::fraction;

hls::top::base_triangle some_record(generator& g) {
  hls::top::base_triangle b{};
  draw_vector(b, draw::uniform, g);
  for (hls::top::base_vertex& v : b.v)
    for (auto& u : v.u) u = hls::from_raw<formats::coordinate>(g.between(0, limit));
  b.last = false;
  return b;
}

// A mesh has begun, and its packet is let in from the next clock on.
class opened {
 public:
  opened() {
    m->begin_i = m->refuse_i = m->close_i = m->stop_i = m->in_valid_i = m->in_last_i = m->out_ready_i = 0;
    m->expected_i = 0;
    tb::put_bits(m->limit_i, 0, hls::bits<64>{{std::uint64_t(limit) | std::uint64_t(limit) << formats::coordinate::width}},
                 2 * formats::coordinate::width);
    m.reset();
    m->begin_i = 1;
    m.clock();
    m->begin_i = 0;
  }
  void offer(hls::top::base_triangle const& b) {
    m->in_valid_i = 1;
    m->in_last_i = b.last;
    tb::put(m->in_i, b);
    m.settle();
  }

  clocked_model<Vedge_engine_input> m;
};

TEST(edge_engine_input, passes_a_record_on_a_clock_later_and_takes_one_every_other_clock) {
  opened bench;
  auto& m = bench.m;
  generator g("input");
  m->out_ready_i = 1;
  for (int i = 0; i < 200; ++i) {
    const hls::top::base_triangle b = some_record(g);
    bench.offer(b);
    ASSERT_TRUE(m->in_ready_o) << i;
    ASSERT_FALSE(m->out_valid_o) << i;
    m.clock();
    ASSERT_TRUE(m->out_valid_o) << i;
    ASSERT_EQ(hls::pack(tb::get<hls::top::base_triangle>(m->out_o)), hls::pack(b)) << i;
    ASSERT_FALSE(m->in_ready_o) << i;
    m.clock();
  }
}

TEST(edge_engine_input, says_what_is_wrong_two_clocks_after_the_record_was_taken) {
  opened bench;
  auto& m = bench.m;
  generator g("wrong");
  m->out_ready_i = 1;
  hls::top::base_triangle b = some_record(g);
  b.v[1].u[0] = hls::from_raw<formats::coordinate>(limit + 1);
  bench.offer(b);
  ASSERT_TRUE(m->in_ready_o);
  m.clock();
  m->in_valid_i = 0;
  EXPECT_FALSE(m->out_valid_o);
  EXPECT_EQ(m->error_o, number(code::none));
  EXPECT_FALSE(m->end_o);
  m.clock();
  EXPECT_EQ(m->error_o, number(code::coordinate_outside_map));
  EXPECT_TRUE(m->end_o);
  m.clock();
  EXPECT_EQ(m->error_o, number(code::none)) << "for one clock";
  EXPECT_FALSE(m->end_o);
}

TEST(edge_engine_input, ends_two_clocks_after_a_stop) {
  opened bench;
  auto& m = bench.m;
  m->stop_i = 1;
  m.clock();
  m->stop_i = 0;
  EXPECT_FALSE(m->end_o);
  m.clock();
  EXPECT_TRUE(m->end_o);
  EXPECT_EQ(m->error_o, number(code::stopped));
  m.clock();
  EXPECT_FALSE(m->end_o);
  EXPECT_EQ(m->error_o, number(code::none));
  EXPECT_TRUE(m->over_o);
}

}  // namespace
}  // namespace relievo::test
