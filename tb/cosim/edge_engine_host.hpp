// edge_engine_host: a Verilated top of the edge engine among its buses, in a plain loop of clocks: an AXI4-Lite master, sources of base
// triangles and texels, a sink of triangles, memories behind its read ports or buses, and the write ports of the builders of maps.
//
//   edge_engine_host<Model, Memories> host(traffic, fail)    Memories: map_ports.hpp, or what else has its face
//   host.driver            edge_engine_driver over the bus; every access takes the clocks it needs, the rest goes on
//   host.base, .texels     words to be offered, in order, each with its tlast
//   host.triangle, .table_word, .normal_word   are called with what comes out, in the clock in which it is taken
//   host.clock(n)          n clocks;  host.idle()  all sources empty;  host.reset()
//   host.quiet_clocks()    clocks since a word moved on another bus than AXI4-Lite, of which a host reads the state for ever
//   host.stopped()         the link at which a run that is quiet stands still, and how
//   fail(text)             in every clock: a word does not hold while it is not taken, tlast and last differ, a word was asked for that is
//                          not of the map, the bus does not answer OKAY, an assertion of the circuit failed; in some clocks: a ready of a
//                          stream goes through the circuit within the clock, a valid waits for its ready
#pragma once
#include <verilated.h>

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "hls/top/top.hpp"
#include "tb/cosim/bus_traffic.hpp"
#include "tb/cosim/coverage.hpp"
#include "tb/cosim/edge_engine_driver.hpp"
#include "tb/cosim/held_word.hpp"
#include "tb/cosim/ports.hpp"

namespace relievo::tb {

template <class Model, class Memories>
class edge_engine_host : public register_bus {
 public:
  edge_engine_host(bus_traffic const& t, failure_hook fail)
      : driver(*this),
        memories(t, [this](std::string const& what) { broken(what); }),
        fail_(std::move(fail)),
        source_pace_(t.idle, t.seed),
        sink_pace_(t.stall, t.seed + 1) {
    context_.randReset(2);
    context_.randSeed(t.reset_seed);
    // An assertion of the circuit that fails is a broken rule, not the end of the program.
    context_.fatalOnError(false);
    model_ = std::make_unique<Model>(&context_);
    model_->aclk = 0;
    reset();
  }
  // A model's parts look for their context in the thread, where another model's may be the last that was set, and gone.
  ~edge_engine_host() override {
    Verilated::threadContextp(&context_);
    model_->final();
  }

  edge_engine_driver driver;
  std::deque<bus_word<hls::top::base_triangle>> base;
  std::deque<bus_word<std::uint16_t>> texels;
  std::function<void(hls::triangle_out const&)> triangle;
  std::function<void(int x, int y, std::uint64_t word)> table_word, normal_word;
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
      kept_.begin();
      if (i > 0 && anything_valid()) broken("something is valid in reset");
    }
    base.clear();
    texels.clear();
    memories.forget();
    offering_base_ = offering_texel_ = offering_aw_ = offering_w_ = offering_ar_ = false;
    write_ = {};
    read_ = {};
    out_hold_.forget();
    table_hold_.forget();
    normal_hold_.forget();
    model_->aresetn = 1;
    edge();
  }

  bool idle() const { return base.empty() && texels.empty(); }
  std::uint64_t quiet_clocks() const { return quiet_; }
  // A memory first; else a word that nobody takes, those behind the circuit first, the sources last; else the circuit itself, from which
  // nothing comes any more.
  std::string stopped() const {
    if (std::string memory = memories.stopped(); !memory.empty()) return memory;
    for (held_word const* h : {&out_hold_, &table_hold_, &normal_hold_})
      if (h->waits()) return std::string(h->name()) + ": a word is not taken";
    if (offering_base_) return "s_axis: a word is not taken";
    if (offering_texel_) return "s_axis_map: a word is not taken";
    return "m_axis: nothing comes, and the circuit asks for nothing";
  }

  void clock(int n = 1) {
    for (int i = 0; i < n; ++i) step();
  }

  std::uint32_t read32(std::uint32_t address) override {
    read_ = {address, 0, true, false};
    for (int i = 0; !read_.done && answered(i, "a read of ", address); ++i) step();
    return read_.word;
  }
  void write32(std::uint32_t address, std::uint32_t word) override {
    write_ = {address, word, true, true, false};
    for (int i = 0; !write_.done && answered(i, "a write of ", address); ++i) step();
  }

 private:
  // Clocks between two looks for paths within a clock, each a twentieth of a clock's work.
  static constexpr std::uint64_t look_clocks = 13;

  bool answered(int waited, char const* what, std::uint32_t address) {
    if (waited < 2000) return true;
    broken(std::string("s_axil: no answer to ") + what + std::to_string(address));
    return false;
  }
  void broken(std::string const& what) { fail_(what + ", clock " + std::to_string(clocks)); }
  void hold(std::string const& what) {
    if (!what.empty()) broken(what);
  }

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
  bool anything_valid() const {
    Model const& m = *model_;
    return m.m_axis_tvalid || m.s_axil_bvalid || m.s_axil_rvalid || m.table_write_valid_o || m.normal_write_valid_o || memories.asks(m);
  }

  // Sources offer; an offer stays.
  void offer() {
    Model& m = *model_;
    offering_base_ = offering_base_ || (!base.empty() && source_pace_.go());
    m.s_axis_tvalid = offering_base_;
    if (offering_base_) {
      put(m.s_axis_tdata, base.front().word);
      m.s_axis_tlast = base.front().last;
    }
    offering_texel_ = offering_texel_ || (!texels.empty() && source_pace_.go());
    m.s_axis_map_tvalid = offering_texel_;
    if (offering_texel_) {
      m.s_axis_map_tdata = texels.front().word;
      m.s_axis_map_tlast = texels.front().last;
    }
    m.m_axis_tready = sink_open && sink_pace_.go();
    m.table_write_ready_i = sink_pace_.go();
    m.normal_write_ready_i = sink_pace_.go();
    memories.offer(m, clocks);
    // Address and data of a write go their own ways.
    offering_aw_ = offering_aw_ || (write_.address_left && source_pace_.go());
    offering_w_ = offering_w_ || (write_.data_left && source_pace_.go());
    offering_ar_ = offering_ar_ || (read_.address_left && source_pace_.go());
    m.s_axil_awvalid = offering_aw_;
    m.s_axil_awaddr = static_cast<SData>(write_.address);
    m.s_axil_wvalid = offering_w_;
    m.s_axil_wdata = write_.word;
    m.s_axil_wstrb = 15;
    m.s_axil_bready = sink_pace_.go();
    m.s_axil_arvalid = offering_ar_;
    m.s_axil_araddr = static_cast<SData>(read_.address);
    m.s_axil_rready = sink_pace_.go();
  }

  // With the readies of the sinks turned over all else stays as it is.
  void look_through() {
    Model& m = *model_;
    const auto seen = [&m] {
      return std::array<bool, 8>{m.s_axis_tready != 0,  m.s_axis_map_tready != 0,   m.s_axil_awready != 0,       m.s_axil_wready != 0,
                                 m.s_axil_arready != 0, m.table_write_valid_o != 0, m.normal_write_valid_o != 0, m.m_axis_tvalid != 0};
    };
    constexpr char const* names[] = {"s_axis", "s_axis_map", "s_axil_aw", "s_axil_w", "s_axil_ar", "table_write", "normal_write", "m_axis"};
    const auto turn = [&m] {
      m.m_axis_tready = !m.m_axis_tready;
      m.table_write_ready_i = !m.table_write_ready_i;
      m.normal_write_ready_i = !m.normal_write_ready_i;
      m.eval();
    };
    const auto before = seen();
    turn();
    const auto after = seen();
    turn();
    for (std::size_t i = 0; i < before.size(); ++i)
      if (before[i] != after[i])
        broken(std::string(names[i]) +
               (i < 5 ? ": its ready follows a sink's within the clock" : ": its valid follows a ready within the clock"));
  }

  // What moves at the edge, on the buses of words.
  void take_words() {
    Model& m = *model_;
    const std::uint64_t answers = memories.answered();
    bool moved = answers != answers_;
    answers_ = answers;
    if (offering_base_ && m.s_axis_tready) {
      base.pop_front();
      offering_base_ = false;
      moved = true;
    }
    if (offering_texel_ && m.s_axis_map_tready) {
      texels.pop_front();
      offering_texel_ = false;
      moved = true;
    }
    hold(out_hold_.look(m.m_axis_tvalid, m.m_axis_tready, m.m_axis_tdata));
    if (m.m_axis_tvalid && m.m_axis_tready) {
      const auto t = get<hls::triangle_out>(m.m_axis_tdata);
      if (t.last != (m.m_axis_tlast != 0)) broken("m_axis: tlast and the record's last differ");
      if (triangle) triangle(t);
      moved = true;
    }
    hold(table_hold_.look(m.table_write_valid_o, m.table_write_ready_i, m.table_write_word_o));
    if (m.table_write_valid_o && m.table_write_ready_i) {
      if (table_word) table_word(m.table_write_x_o, m.table_write_y_o, m.table_write_word_o);
      moved = true;
    }
    hold(normal_hold_.look(m.normal_write_valid_o, m.normal_write_ready_i, m.normal_write_word_o));
    if (m.normal_write_valid_o && m.normal_write_ready_i) {
      if (normal_word) normal_word(m.normal_write_x_o, m.normal_write_y_o, m.normal_write_word_o);
      moved = true;
    }
    memories.take(m, clocks);
    quiet_ = moved ? 0 : quiet_ + 1;
  }

  // And on the bus of registers.
  void take_access() {
    Model& m = *model_;
    if (offering_aw_ && m.s_axil_awready) write_.address_left = offering_aw_ = false;
    if (offering_w_ && m.s_axil_wready) write_.data_left = offering_w_ = false;
    if (offering_ar_ && m.s_axil_arready) read_.address_left = offering_ar_ = false;
    const auto response = [this](int code, char const* what, std::uint32_t address) {
      okay = code == 0;
      if (!okay && !may_refuse) broken(std::string("s_axil: ") + what + std::to_string(address) + " was not answered with OKAY");
    };
    if (m.s_axil_bvalid && m.s_axil_bready) {
      response(m.s_axil_bresp, "a write of ", write_.address);
      write_.done = true;
    }
    if (m.s_axil_rvalid && m.s_axil_rready) {
      response(m.s_axil_rresp, "a read of ", read_.address);
      read_.word = m.s_axil_rdata;
      read_.done = true;
    }
  }

  void step() {
    Model& m = *model_;
    quiet();
    offer();
    m.eval();
    if (clocks % look_clocks == 0) look_through();
    take_words();
    take_access();
    m.aclk = 1;
    m.eval();
    m.aclk = 0;
    if (context_.gotError()) {
      context_.gotError(false);
      broken("an assertion of the circuit failed, which it has printed");
    }
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

  failure_hook fail_;
  VerilatedContext context_;
  std::unique_ptr<Model> model_;
  keep_coverage kept_{context_};
  pacer source_pace_, sink_pace_;
  bool offering_base_ = false, offering_texel_ = false, offering_aw_ = false, offering_w_ = false, offering_ar_ = false;
  std::uint64_t quiet_ = 0, answers_ = 0;
  held_word out_hold_{"m_axis"}, table_hold_{"table_write"}, normal_hold_{"normal_write"};
  write_access write_;
  read_access read_;
};

}  // namespace relievo::tb
