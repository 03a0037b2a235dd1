// edge_engine_bench: a Verilated top of the edge engine and its host (tb/cosim/edge_engine_host.hpp) for tests: every broken rule is a
// failure, and what came out is kept.
//
//   edge_engine_bench<Model, Memories> bench(traffic)
//   bench.packets          what came out, a list a packet;  bench.table, .normals  what the builders wrote
//   bench.load(scene)      what the memories hold
#pragma once
#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

#include "tb/cosim/edge_engine_host.hpp"
#include "tb/cosim/map_ports.hpp"
#include "tests/support/engine_scene.hpp"
#include "tests/support/stream_unit.hpp"

namespace relievo::test {

template <class Model, class Memories>
class edge_engine_bench : public tb::edge_engine_host<Model, Memories> {
  using host = tb::edge_engine_host<Model, Memories>;

 public:
  explicit edge_engine_bench(traffic const& t) : host(on_buses(t), [](std::string const& what) { ADD_FAILURE() << what; }) {
    this->triangle = [this](hls::triangle_out const& out) {
      if (packets.empty() || packet_over_) packets.emplace_back();
      packets.back().push_back(out);
      packet_over_ = out.last;
    };
    this->table_word = [this](int x, int y, std::uint64_t word) { table[{x, y}] = word; };
    this->normal_word = [this](int x, int y, std::uint64_t word) { normals[{x, y}] = word; };
  }

  std::vector<std::vector<hls::triangle_out>> packets;
  std::map<std::pair<int, int>, std::uint64_t> table, normals;

  void reset() {
    host::reset();
    packets.clear();
    packet_over_ = false;
  }
  void load(engine_scene const& s) {
    this->memories.load({s.map.width(), s.map.height(), s.map.words().data(), s.map.table().words, s.normals.data()});
  }

 private:
  // Sixteenths in percent.
  static tb::bus_traffic on_buses(traffic const& t) {
    static generator g("edge_engine bench");
    tb::bus_traffic b;
    b.idle = static_cast<int>(100 * t.idle / 16);
    b.stall = static_cast<int>(100 * t.stall / 16);
    b.latency_low = static_cast<int>(t.latency_low);
    b.latency_high = static_cast<int>(t.latency_high);
    b.seed = g();
    b.reset_seed = reset_seed();
    return b;
  }

  bool packet_over_ = false;
};

}  // namespace relievo::test
