// edge_engine_registers: its clocks: a write is answered and seen by the engine exactly so many clocks after it was offered, a read too,
// and the next one begins with the answer. What the registers hold is tested through the bus (tests/top/edge_engine_rtl.cpp).
#include <gtest/gtest.h>

#include <cstddef>

#include "Vedge_engine_registers.h"
#include "edge_engine_registers.h"
#include "tests/support/clocked_model.hpp"

namespace relievo::test {
namespace {

constexpr int write_clocks = 4, read_clocks = 5;

class host {
 public:
  host() {
    m->s_axil_awvalid = m->s_axil_wvalid = m->s_axil_arvalid = 0;
    m->s_axil_bready = m->s_axil_rready = 1;
    m->s_axil_awprot = m->s_axil_arprot = 0;
    m->s_axil_wstrb = 15;
    m.reset();
  }
  // An access from the clock in which it is offered to that in which its answer is taken; sees() is asked after every edge.
  template <class Sees>
  int write(std::uint32_t address, std::uint32_t word, Sees sees) {
    m->s_axil_awaddr = static_cast<SData>(address);
    m->s_axil_wdata = word;
    m->s_axil_awvalid = m->s_axil_wvalid = 1;
    for (int clocks = 1;; ++clocks) {
      m.settle();
      const bool aw = m->s_axil_awready, w = m->s_axil_wready, b = m->s_axil_bvalid;
      m.clock();
      if (aw) m->s_axil_awvalid = 0;
      if (w) m->s_axil_wvalid = 0;
      sees(clocks);
      if (b || clocks == 100) return clocks;
    }
  }
  int read(std::uint32_t address, std::uint32_t& word) {
    m->s_axil_araddr = static_cast<SData>(address);
    m->s_axil_arvalid = 1;
    for (int clocks = 1;; ++clocks) {
      m.settle();
      const bool ar = m->s_axil_arready, r = m->s_axil_rvalid;
      word = m->s_axil_rdata;
      m.clock();
      if (ar) m->s_axil_arvalid = 0;
      if (r || clocks == 100) return clocks;
    }
  }
  clocked_model<Vedge_engine_registers> m;
};

constexpr std::uint32_t expected_triangles = offsetof(edge_engine_t, expected_triangles), control = offsetof(edge_engine_t, control);

TEST(edge_engine_registers, a_write_takes_4_clocks_and_is_seen_within_them) {
  host h;
  for (std::uint32_t i = 1; i < 20; ++i) {
    int seen = 0;
    const auto sees = [&](int clocks) {
      if (seen == 0 && h.m->expected_o == 1000 * i) seen = clocks;
    };
    ASSERT_EQ(h.write(expected_triangles, 1000 * i, sees), write_clocks) << i;
    ASSERT_EQ(seen, 3) << i;
  }
}

TEST(edge_engine_registers, a_read_takes_5_clocks) {
  host h;
  for (std::uint32_t i = 1; i < 20; ++i) {
    h.write(expected_triangles, 1000 * i, [](int) {});
    for (int again = 0; again < 3; ++again) {
      std::uint32_t word = 0;
      ASSERT_EQ(h.read(expected_triangles, word), read_clocks) << i;
      ASSERT_EQ(word, 1000 * i);
    }
  }
}

TEST(edge_engine_registers, a_start_is_one_clock_of_control) {
  host h;
  for (int i = 0; i < 3; ++i) {
    int starts = 0, first = 0;
    h.write(control, EDGE_ENGINE__CONTROL__START_bm, [&](int clocks) {
      if (h.m->control_o != 0 && starts++ == 0) first = clocks;
    });
    h.m.clock();
    starts += h.m->control_o != 0;
    EXPECT_EQ(first, 3);
    EXPECT_EQ(starts, 1);
  }
}

}  // namespace
}  // namespace relievo::test
