// edge_engine_bench: the Verilated edge engine among its buses, in a plain loop of clocks: an AXI4-Lite master, sources of base triangles
// and texels, a sink of triangles, memories behind the read ports, and the memories that the builders fill.
//
//   edge_engine_bench<Model> bench(traffic)      with memories behind read ports (map_ports.hpp), or, as a second parameter, others
//   bench.driver           edge_engine_driver over the bus; every access takes the clocks it needs, the rest of the bench goes on
//   bench.base, .texels    words to be offered, in order, each with its tlast
//   bench.packets          what came out, a list a packet;  bench.table, .normals  what the builders wrote
//   bench.load(scene)      what the memories hold
//   bench.clock(n)         n clocks;  bench.idle()  all sources empty
//   Checked in every clock: words hold while they are not taken, tlast is last, only words of the map are asked for and written, and
//   the bus answers OKAY.
#pragma once
#include <verilated.h>

#include <deque>
#include <map>
#include <utility>
#include <vector>

#include "hls/top/top.hpp"
#include "tb/cosim/coverage.hpp"
#include "tb/cosim/edge_engine_driver.hpp"
#include "tb/cosim/ports.hpp"
#include "tests/support/held_word.hpp"
#include "tests/support/map_ports.hpp"
#include "tests/support/stream_unit.hpp"

namespace relievo::test {

template <class Word>
struct bus_word {
  Word word;
  bool last;
};

template <class Model, class Memories = map_ports<Model>>
class edge_engine_bench : public tb::register_bus {
 public:
  explicit edge_engine_bench(traffic const& t) : driver(*this), traffic_(t), g_("edge_engine bench") {
    context_.randReset(2);
    context_.randSeed(static_cast<int>(seed() & 0x7fffffff) + 1);
    model_ = std::make_unique<Model>(&context_);
    model_->aclk = 0;
    reset();
  }
  ~edge_engine_bench() override { model_->final(); }

  tb::edge_engine_driver driver;
  std::deque<bus_word<hls::top::base_triangle>> base;
  std::deque<bus_word<std::uint16_t>> texels;
  std::vector<std::vector<hls::triangle_out>> packets;
  std::map<std::pair<int, int>, std::uint64_t> table, normals;
  bool okay = true;         // the response to the last access
  bool may_refuse = false;  // another response than OKAY is no failure
  bool sink_open = true;
  std::uint64_t clocks = 0;
  Memories memories;

  void reset() {
    // Two clocks, as the circuit asks for. Nothing may be offered to anybody while it lasts, nor be left of what was under way before.
    model_->aresetn = 0;
    quiet();
    for (int i = 0; i < 2; ++i) {
      edge();
      if (i > 0) expect_nothing_valid();
    }
    base.clear();
    texels.clear();
    packets.clear();
    memories.forget();
    offering_base_ = offering_texel_ = offering_aw_ = offering_w_ = offering_ar_ = packet_over_ = false;
    write_ = {};
    read_ = {};
    out_hold_.forget();
    table_hold_.forget();
    normal_hold_.forget();
    model_->aresetn = 1;
    edge();
  }

  // What the memories answer from.
  void load(engine_scene const& s) { memories.load(s); }

  bool idle() const { return base.empty() && texels.empty(); }

  void clock(int n = 1) {
    for (int i = 0; i < n; ++i) step();
  }

  std::uint32_t read32(std::uint32_t address) override {
    read_ = {address, 0, true, false};
    for (int i = 0; !read_.done; ++i) {
      if (i == 2000) {
        ADD_FAILURE() << "no answer to a read of " << address;
        return 0;
      }
      step();
    }
    return read_.word;
  }
  void write32(std::uint32_t address, std::uint32_t word) override {
    write_ = {address, word, true, true, false};
    for (int i = 0; !write_.done; ++i) {
      if (i == 2000) {
        ADD_FAILURE() << "no answer to a write of " << address;
        return;
      }
      step();
    }
  }

 private:
  void quiet() {
    Model& m = *model_;
    m.s_axil_awvalid = m.s_axil_wvalid = m.s_axil_bready = m.s_axil_arvalid = m.s_axil_rready = 0;
    m.s_axil_awprot = m.s_axil_arprot = 0;
    m.s_axis_tvalid = m.s_axis_map_tvalid = m.m_axis_tready = 0;
    m.table_write_ready_i = m.normal_write_ready_i = 0;
    memories.quiet(m);
  }
  void edge() {
    model_->eval();
    model_->aclk = 1;
    model_->eval();
    model_->aclk = 0;
    model_->eval();
  }

  void expect_nothing_valid() {
    Model const& m = *model_;
    EXPECT_FALSE(m.m_axis_tvalid || m.s_axil_bvalid || m.s_axil_rvalid || m.table_write_valid_o || m.normal_write_valid_o) << "in reset";
    memories.expect_nothing_asked(m);
  }

  bool moves(std::uint64_t rests) { return g_.below(16) >= rests; }

  void step() {
    Model& m = *model_;
    quiet();
    // Sources offer; an offer stays.
    offering_base_ = offering_base_ || (!base.empty() && moves(traffic_.idle));
    m.s_axis_tvalid = offering_base_;
    if (offering_base_) {
      tb::put(m.s_axis_tdata, base.front().word);
      m.s_axis_tlast = base.front().last;
    }
    offering_texel_ = offering_texel_ || (!texels.empty() && moves(traffic_.idle));
    m.s_axis_map_tvalid = offering_texel_;
    if (offering_texel_) {
      m.s_axis_map_tdata = texels.front().word;
      m.s_axis_map_tlast = texels.front().last;
    }
    m.m_axis_tready = sink_open && moves(traffic_.stall);
    m.table_write_ready_i = moves(traffic_.stall);
    m.normal_write_ready_i = moves(traffic_.stall);
    memories.offer(m, traffic_, g_, clocks);
    // Address and data of a write go their own ways.
    offering_aw_ = offering_aw_ || (write_.address_left && moves(traffic_.idle));
    offering_w_ = offering_w_ || (write_.data_left && moves(traffic_.idle));
    offering_ar_ = offering_ar_ || (read_.address_left && moves(traffic_.idle));
    m.s_axil_awvalid = offering_aw_;
    m.s_axil_awaddr = static_cast<SData>(write_.address);
    m.s_axil_wvalid = offering_w_;
    m.s_axil_wdata = write_.word;
    m.s_axil_wstrb = 15;
    m.s_axil_bready = moves(traffic_.stall);
    m.s_axil_arvalid = offering_ar_;
    m.s_axil_araddr = static_cast<SData>(read_.address);
    m.s_axil_rready = moves(traffic_.stall);
    m.eval();

    // What moves at the edge.
    if (offering_base_ && m.s_axis_tready) {
      base.pop_front();
      offering_base_ = false;
    }
    if (offering_texel_ && m.s_axis_map_tready) {
      texels.pop_front();
      offering_texel_ = false;
    }
    out_hold_.look(m.m_axis_tvalid, m.m_axis_tready, m.m_axis_tdata, clocks);
    if (m.m_axis_tvalid && m.m_axis_tready) {
      const auto t = tb::get<hls::triangle_out>(m.m_axis_tdata);
      EXPECT_EQ(t.last, m.m_axis_tlast != 0);
      if (packets.empty() || packet_over_) packets.emplace_back();
      packets.back().push_back(t);
      packet_over_ = t.last;
    }
    table_hold_.look(m.table_write_valid_o, m.table_write_ready_i, m.table_write_word_o, clocks);
    if (m.table_write_valid_o && m.table_write_ready_i) table[{m.table_write_x_o, m.table_write_y_o}] = m.table_write_word_o;
    normal_hold_.look(m.normal_write_valid_o, m.normal_write_ready_i, m.normal_write_word_o, clocks);
    if (m.normal_write_valid_o && m.normal_write_ready_i) normals[{m.normal_write_x_o, m.normal_write_y_o}] = m.normal_write_word_o;
    memories.take(m, traffic_, g_, clocks);
    if (offering_aw_ && m.s_axil_awready) write_.address_left = offering_aw_ = false;
    if (offering_w_ && m.s_axil_wready) write_.data_left = offering_w_ = false;
    if (offering_ar_ && m.s_axil_arready) read_.address_left = offering_ar_ = false;
    if (m.s_axil_bvalid && m.s_axil_bready) {
      okay = m.s_axil_bresp == 0;
      EXPECT_TRUE(okay || may_refuse) << "a write of " << write_.address;
      write_.done = true;
    }
    if (m.s_axil_rvalid && m.s_axil_rready) {
      okay = m.s_axil_rresp == 0;
      EXPECT_TRUE(okay || may_refuse) << "a read of " << read_.address;
      read_.word = m.s_axil_rdata;
      read_.done = true;
    }
    m.aclk = 1;
    m.eval();
    m.aclk = 0;
    ++clocks;
  }

  struct write_access {
    std::uint32_t address = 0, word = 0;
    bool address_left = false, data_left = false, done = true;
  };
  struct read_access {
    std::uint32_t address = 0, word = 0;
    bool address_left = false, done = true;
  };

  VerilatedContext context_;
  std::unique_ptr<Model> model_;
  const tb::keep_coverage kept_{context_};
  traffic traffic_;
  generator g_;
  bool offering_base_ = false, offering_texel_ = false, offering_aw_ = false, offering_w_ = false, offering_ar_ = false;
  bool packet_over_ = false;
  held_word out_hold_{"m_axis"}, table_hold_{"table_write"}, normal_hold_{"normal_write"};
  write_access write_;
  read_access read_;
};

}  // namespace relievo::test
