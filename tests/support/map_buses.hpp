// map_buses: the map memories of a Verilated edge_engine_axi: three memories of bytes behind its four AXI4 read buses, each answering in
// order, after the traffic's clocks, with stalls.
//   quiet, load, forget, offer, take   as tb/cosim/map_ports.hpp
//   bad_beats          so many beats to come are answered with SLVERR, and with the right word
//   bursts_of_two()    of the bursts so far;  stopped()  as tb/cosim/map_ports.hpp
//   Checked: every address is one of a word of the map it is for, aligned; ar holds until it is taken; bursts are of whole words, one or,
//   of texels and normals, two, and none crosses 4 KB. rlast comes with the last beat of each.
#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <deque>
#include <string>
#include <type_traits>
#include <utility>

#include "tb/cosim/bus_traffic.hpp"
#include "tb/cosim/held_word.hpp"
#include "tb/cosim/map_ports.hpp"
#include "tests/support/random.hpp"

namespace relievo::test {

template <class Model>
class map_buses {
 public:
  static constexpr std::uint64_t displacement_base = 0x10000, table_base = 0x40000, normal_base = 0x80008;
  int bad_beats = 0;

  void quiet(Model& m) {
    m.displacement_base_i = displacement_base;
    m.table_base_i = table_base;
    m.normal_base_i = normal_base;
    each(m, [](bus&, auto ar, auto r) {
      *ar.ready = 0;
      *r.valid = 0;
    });
  }
  map_buses(tb::bus_traffic const& t, tb::failure_hook fail)
      : fail_(std::move(fail)), source_(t.idle, t.seed), sink_(t.stall, t.seed + 1), times_(t, 2) {}

  void load(tb::map_contents const& c) { map_ = c; }
  std::uint64_t answered() const { return answered_; }
  std::uint64_t bursts_of_two() const { return bursts_of_two_; }
  std::string stopped() const {
    for (bus const* b : {&table_, &quad_, &place_, &normal_})
      if (!b->beats.empty())
        return std::string(b->name) + (b->offered ? "_r: a beat is not taken" : "_r: a beat does not come") + ", " +
               std::to_string(b->beats.size()) + " are awaited";
    for (bus const* b : {&table_, &quad_, &place_, &normal_})
      if (b->hold.waits()) return std::string(b->name) + "_ar: a word is not taken";
    return {};
  }
  // After a reset.
  void forget() {
    for (bus* b : {&table_, &quad_, &place_, &normal_}) {
      b->beats.clear();
      b->offered = false;
      b->hold.forget();
    }
  }
  bool asks(Model const& m) const {
    return m.m_axi_table_arvalid || m.m_axi_quad_arvalid || m.m_axi_place_arvalid || m.m_axi_normal_arvalid;
  }
  void offer(Model& m, std::uint64_t clock) {
    each(m, [&](bus& b, auto ar, auto r) {
      *ar.ready = sink_.go();
      if (!b.offered && !b.beats.empty() && b.beats.front().due <= clock && source_.go()) b.offered = true;
      *r.valid = b.offered;
      *r.resp = static_cast<CData>(b.offered ? (b.beats.front().bad ? 2 : 0) : g_.below(4));
      *r.data = b.offered ? b.beats.front().data : g_();
      *r.last = static_cast<CData>(b.offered ? b.beats.front().last : g_.chance(2));
    });
  }
  void take(Model& m, std::uint64_t clock) {
    each(m, [&](bus& b, auto ar, auto r) {
      if (b.offered && *r.ready) {
        b.beats.pop_front();
        b.offered = false;
        ++answered_;
      }
      if (const std::string broken = b.hold.look(*ar.valid, *ar.ready, *ar.address); !broken.empty()) fail_(broken);
      if (!*ar.valid || !*ar.ready) return;
      const unsigned beats = *ar.length + 1u;
      EXPECT_LE(beats, b.base == table_base ? 1u : 2u);
      EXPECT_LE(*ar.address % 4096 + beats * b.bytes, 4096u) << b.name << ": a burst crosses 4 KB";
      EXPECT_EQ(1u << *ar.size, b.bytes);
      EXPECT_EQ(*ar.kind, 1);
      EXPECT_EQ(*ar.protection, 0);
      bursts_of_two_ += beats == 2 ? 1 : 0;
      std::uint64_t due = times_.due(clock, b.beats.empty() ? 0 : b.beats.back().due);
      for (unsigned i = 0; i < beats; ++i, ++due) {
        const bool bad = bad_beats > 0;
        bad_beats -= bad ? 1 : 0;
        b.beats.push_back({due, beat(b, *ar.address + i * b.bytes), i + 1 == beats, bad});
      }
    });
  }

 private:
  struct beat_word {
    std::uint64_t due, data;
    bool last, bad;
  };
  struct bus {
    char const* name;
    std::uint64_t base;
    unsigned bytes;
    tb::held_word hold;
    std::deque<beat_word> beats;
    bool offered = false;
  };
  template <class Address>
  struct ar_ports {
    Address const* address;
    CData const *length, *size, *kind, *protection, *valid;
    CData* ready;
  };
  template <class Data>
  struct r_ports {
    Data* data;
    CData *resp, *last, *valid;
    CData const* ready;
  };

  // The word at an address on its lanes of eight bytes; anything on the others.
  std::uint64_t beat(bus const& b, std::uint64_t address) {
    const std::uint64_t at = (address - b.base) / b.bytes;
    if (address < b.base || (address - b.base) % b.bytes != 0 ||
        at >= static_cast<std::size_t>(map_.width) * static_cast<std::size_t>(map_.height)) {
      fail_(std::string(b.name) + ": address " + std::to_string(address) + " is no word's of the map");
      return 0;
    }
    if (b.bytes == 2) {
      const unsigned shift = 8 * (address % 8);
      return (g_() & ~(std::uint64_t(0xffff) << shift)) | std::uint64_t(map_.texels[at]) << shift;
    }
    const std::uint64_t above = g_() << (b.base == table_base ? 40 : 48);
    return above | (b.base == table_base ? map_.table[at] : map_.normals[at]);
  }

#define RELIEVO_BUS(name)                                                                                          \
  call(name##_,                                                                                                    \
       ar_ports<std::remove_reference_t<decltype(m.m_axi_##name##_araddr)>>{                                       \
           &m.m_axi_##name##_araddr, &m.m_axi_##name##_arlen, &m.m_axi_##name##_arsize, &m.m_axi_##name##_arburst, \
           &m.m_axi_##name##_arprot, &m.m_axi_##name##_arvalid, &m.m_axi_##name##_arready},                        \
       r_ports<std::remove_reference_t<decltype(m.m_axi_##name##_rdata)>>{                                         \
           &m.m_axi_##name##_rdata, &m.m_axi_##name##_rresp, &m.m_axi_##name##_rlast, &m.m_axi_##name##_rvalid, &m.m_axi_##name##_rready})
  template <class Call>
  void each(Model& m, Call const& call) {
    RELIEVO_BUS(table);
    RELIEVO_BUS(quad);
    RELIEVO_BUS(place);
    RELIEVO_BUS(normal);
  }
#undef RELIEVO_BUS

  tb::failure_hook fail_;
  tb::map_contents map_;
  tb::pacer source_, sink_;
  tb::answer_times times_;
  generator g_{"map_buses"};
  std::uint64_t answered_ = 0, bursts_of_two_ = 0;
  bus table_{"m_axi_table", table_base, 8, tb::held_word("m_axi_table_ar"), {}};
  bus quad_{"m_axi_quad", displacement_base, 2, tb::held_word("m_axi_quad_ar"), {}};
  bus place_{"m_axi_place", displacement_base, 2, tb::held_word("m_axi_place_ar"), {}};
  bus normal_{"m_axi_normal", normal_base, 8, tb::held_word("m_axi_normal_ar"), {}};
};

}  // namespace relievo::test
