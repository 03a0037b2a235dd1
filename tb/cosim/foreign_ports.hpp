// foreign_ports: the ports of a module that an HLS tool made of an entry point of hls/top with one word in and one word out, under the
// names that Vitis HLS gives them. What a module has of these is found out from its Verilated class:
//   ap_clk; ap_rst_n or ap_rst                             clock and reset
//   in_r_TDATA, _TVALID, _TREADY, out_r_TDATA, ...         the streams, words packed as hls/core/packed.hpp has them
//   s_axi_control_*, or regs                               the registers: AXI4-Lite (where the entry point says s_axilite), or a plain port
//   ap_start, ap_done, ap_idle, ap_ready, ap_continue      only without ap_ctrl_none: start and continue are held at 1, done and the others
//                                                          are not looked at, as every call begins with a word and ends with one
// A module with other names gets a wrapper of this kind (docs/foreign_rtl.md).
#pragma once
#include <cstdint>
#include <deque>
#include <string>
#include <type_traits>

#include "tb/cosim/ports_of_lanes.hpp"
#include "tb/cosim/unit_circuits.hpp"

namespace relievo::tb {

namespace detail {
#define RELIEVO_PORT(port)                \
  template <class M, class = void>        \
  struct has_##port : std::false_type {}; \
  template <class M>                      \
  struct has_##port<M, std::void_t<decltype(std::declval<M&>().port)>> : std::true_type {};
RELIEVO_PORT(ap_rst_n)
RELIEVO_PORT(ap_rst)
RELIEVO_PORT(ap_start)
RELIEVO_PORT(ap_continue)
RELIEVO_PORT(regs)
RELIEVO_PORT(s_axi_control_AWVALID)
#undef RELIEVO_PORT
}  // namespace detail

template <class Model>
class foreign_ports {
 public:
  static constexpr bool has_bus = detail::has_s_axi_control_AWVALID<Model>::value;
  static constexpr bool has_regs_port = detail::has_regs<Model>::value;
  static_assert(detail::has_ap_rst_n<Model>::value || detail::has_ap_rst<Model>::value, "the module has neither ap_rst_n nor ap_rst");

  explicit foreign_ports(Model& model) : m_(model) {
    m_.in_r_TVALID = 0;
    m_.out_r_TREADY = 0;
    if constexpr (detail::has_ap_continue<Model>::value) m_.ap_continue = 1;
    if constexpr (has_bus) {
      m_.s_axi_control_AWVALID = m_.s_axi_control_WVALID = m_.s_axi_control_ARVALID = 0;
      m_.s_axi_control_BREADY = m_.s_axi_control_RREADY = 1;
      m_.s_axi_control_WSTRB = 0xf;
    }
  }

  void clock(bool high) {
    m_.ap_clk = high;
    m_.eval();
  }
  void running(bool yes) {
    if constexpr (detail::has_ap_rst_n<Model>::value) m_.ap_rst_n = yes;
    if constexpr (detail::has_ap_rst<Model>::value) m_.ap_rst = !yes;
    if constexpr (detail::has_ap_start<Model>::value) m_.ap_start = yes;
  }
  void put_in(bool valid, hls::bits<widest_record> const& word, int bits) {
    m_.in_r_TVALID = valid;
    if (valid) put_bits(m_.in_r_TDATA, 0, word, bits);
  }
  void put_ready(bool ready) { m_.out_r_TREADY = ready; }
  bool in_ready() const { return m_.in_r_TREADY != 0; }
  bool out_valid() const { return m_.out_r_TVALID != 0; }
  hls::bits<widest_record> out(int bits) const { return get_bits<widest_record>(m_.out_r_TDATA, 0, bits); }

  // Registers: a plain port has them at once, the bus takes a write for each 32 bits from `offset` on.
  void set_regs(hls::bits<widest_record> const& word, int bits, int offset) {
    if constexpr (has_regs_port) put_bits(m_.regs, 0, word, bits);
    if constexpr (has_bus)
      for (int at = 0; at < bits; at += 32)
        writes_.push_back(
            {static_cast<std::uint32_t>(offset + at / 8), static_cast<std::uint32_t>((word.limb[at / 64] >> (at % 64)) & 0xffffffffu)});
  }
  bool regs_set() const { return writes_.empty(); }
  // Once a clock, before the rising edge: offers the write under way; after the edge: what of it was taken.
  void offer_write(bool yes) {
    if constexpr (has_bus) {
      const bool open = yes && !writes_.empty();
      m_.s_axi_control_AWVALID = open && !address_taken_;
      m_.s_axi_control_WVALID = open && !data_taken_;
      if (!open) return;
      m_.s_axi_control_AWADDR = static_cast<std::remove_reference_t<decltype(m_.s_axi_control_AWADDR)>>(writes_.front().address);
      m_.s_axi_control_WDATA = writes_.front().data;
    }
  }
  // The handshakes of the coming edge, as they stand with all inputs put.
  void look_at_write() {
    if constexpr (has_bus) {
      address_taken_ = address_taken_ || (m_.s_axi_control_AWVALID && m_.s_axi_control_AWREADY);
      data_taken_ = data_taken_ || (m_.s_axi_control_WVALID && m_.s_axi_control_WREADY);
      if (m_.s_axi_control_BVALID && address_taken_ && data_taken_) {
        refused_ = refused_ || m_.s_axi_control_BRESP != 0;
        address_taken_ = data_taken_ = false;
        writes_.pop_front();
      }
    }
  }
  bool write_refused() const { return refused_; }

 private:
  struct bus_write {
    std::uint32_t address, data;
  };
  Model& m_;
  std::deque<bus_write> writes_;
  bool address_taken_ = false, data_taken_ = false, refused_ = false;
};

}  // namespace relievo::tb
