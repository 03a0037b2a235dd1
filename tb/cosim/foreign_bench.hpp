// foreign_bench: somebody else's circuit of a unit among the SystemC modules of the bench: source, sink, a checker on both links, watchdog.
//
//   foreign_bench<Model> bench(unit, ...)     one a process
//   bench.run(traffic, in, regs, expected)    reset, registers, words in; the words out are held against those expected, in order, and the
//                                             run ends with the first that differs, and its clock
//   Errors: cosim_error when a rule of a link is broken, a word too many comes, the bits beside a word are not zero, a register write is
//   refused, or nothing moves for 10,000 clocks.
//   The module's inputs change at the falling edge and its outputs are looked at before the rising one, so that a valid or ready which
//   follows an input within the clock is allowed here. The bench of the whole engine (engine_device.hpp) refuses that, somebody else's too.
#pragma once
#include <verilated.h>

#include <algorithm>
#include <memory>

#include "tb/cosim/engine_bench.hpp"
#include "tb/cosim/foreign_ports.hpp"
#include "tb/cosim/stream_ends.hpp"

namespace relievo::tb {

using foreign_word = hls::bits<widest_record>;

template <class Model>
class foreign_device : public sc_core::sc_module {
 public:
  SC_HAS_PROCESS(foreign_device);
  foreign_device(sc_core::sc_module_name name, link<foreign_word>& in, link<foreign_word>& out, bench_wires& wires,
                 VerilatedContext& context, int in_bits, int out_bits)
      : sc_module(name), in_(in), out_(out), wires_(wires), in_bits_(in_bits), out_bits_(out_bits), model_(&context), ports(model_) {
    ports.running(false);
    ports.clock(false);
    SC_METHOD(rise);
    sensitive << wires.clock.posedge_event();
    dont_initialize();
    SC_METHOD(fall);
    sensitive << wires.clock.negedge_event();
    dont_initialize();
  }

 private:
  void rise() {
    ++wires_.clocks;
    ports.look_at_write();
    ports.clock(true);
    ports.clock(false);
  }
  void fall() {
    const bool running = wires_.running.read();
    ports.running(running);
    ports.put_in(in_.valid.read() && running, in_.word.read(), in_bits_);
    ports.put_ready(out_.ready.read());
    ports.offer_write(running);
    ports.clock(false);
    show();
    if (ports.write_refused()) wires_.fail("s_axi_control: a write was answered with an error");
    if (!running && ports.out_valid() && wires_.clocks > 4) wires_.fail(out_.name + ": valid in reset");
  }
  void show() {
    in_.ready.write(ports.in_ready());
    out_.valid.write(ports.out_valid());
    if (ports.out_valid()) out_.word.write(ports.out(out_bits_));
  }

  link<foreign_word>&in_, &out_;
  bench_wires& wires_;
  int in_bits_, out_bits_;
  Model model_;

 public:
  foreign_ports<Model> ports;
};

struct foreign_traffic {
  int idle = 0, stall = 0;  // percent
  std::uint64_t seed = 1;
};
struct foreign_run {
  std::size_t words = 0;      // that came out
  std::uint64_t latency = 0;  // from the first word taken to the first word out
  double interval = 0;        // clocks a word, from the first word out to the last
  // The last that came is not the one expected.
  bool wrong = false;
  unit_words last;
  std::uint64_t clock = 0;
};

template <class Model>
class foreign_bench {
 public:
  foreign_bench(pure_unit const& unit, VerilatedContext& context, int regs_offset)
      : unit_(unit),
        regs_offset_(regs_offset),
        device_("unit", in_, out_, wires_, context, padded(unit.in), padded(unit.out)),
        source_("source", in_, wires_, pacer(0, 1)),
        sink_("sink", out_, wires_, pacer(0, 1)),
        check_in_("check_in", in_, wires_, true),
        check_out_("check_out", out_, wires_, true) {
    sink_.take = [this](foreign_word const& word) { take(word); };
  }

  foreign_run run(foreign_traffic const& traffic, std::vector<unit_words> const& in, unit_words const& regs,
                  std::vector<unit_words> const& expected) {
    std::vector<foreign_word> words;
    words.reserve(in.size());
    for (unit_words const& w : in) words.push_back(packed(w, unit_.in));
    result_ = {};
    expected_ = &expected;
    source_.load(nullptr);
    source_.set_pace(pacer(traffic.idle, traffic.seed));
    sink_.set_pace(pacer(traffic.stall, traffic.seed + 1));
    wires_.running.write(false);
    advance(8);
    wires_.running.write(true);
    device_.ports.set_regs(packed(regs, unit_.regs), padded(unit_.regs), regs_offset_);
    for (int i = 0; !device_.ports.regs_set(); ++i) {
      advance(1);
      if (i > limit) throw cosim_error("s_axi_control: a write was not answered for " + std::to_string(limit) + " clocks");
    }
    advance(4);
    check_in_.forget();
    check_out_.forget();
    source_.load(&words);
    std::uint64_t first_in = 0, first_out = 0;
    while (result_.words < expected.size()) {
      advance(1);
      if (first_in == 0 && check_in_.counts().moved != 0) first_in = wires_.clocks;
      if (first_out == 0 && check_out_.counts().moved != 0) first_out = wires_.clocks;
      if (result_.wrong) return result_;
      watch();
    }
    const std::uint64_t last_out = wires_.clocks;
    advance(64);  // what comes too much
    source_.load(nullptr);
    result_.latency = first_out - first_in;
    if (expected.size() > 1) result_.interval = static_cast<double>(last_out - first_out) / static_cast<double>(expected.size() - 1);
    return result_;
  }

 private:
  static constexpr int limit = 10000;
  static int padded(std::vector<field> const& fields) { return (packed_width(fields) + 7) / 8 * 8; }

  void take(foreign_word const& word) {
    if (result_.wrong) return;
    if (result_.words == expected_->size()) {
      wires_.fail("out_r: a word more than went in");
      return;
    }
    result_.last = unpacked(word, unit_.out);
    result_.clock = wires_.clocks;
    result_.wrong = result_.last != (*expected_)[result_.words];
    if (!result_.wrong && packed(result_.last, unit_.out) != word)
      wires_.fail("out_r: the bits beside the word are not zero, word " + std::to_string(result_.words));
    if (!result_.wrong) ++result_.words;
  }
  void advance(int clocks) {
    sc_core::sc_start(clocks, sc_core::SC_NS);
    if (wires_.failure.empty()) return;
    const std::string what = wires_.failure;
    wires_.failure.clear();
    throw cosim_error(what);
  }
  void watch() const {
    link_counts const &in = check_in_.counts(), &out = check_out_.counts();
    if (std::min(in.quiet, out.quiet) < limit) return;
    const auto say = [](link_counts const& c) {
      return " " + c.name + (c.waiting ? ": a word waits" : ": idle") + " after " + std::to_string(c.moved) + ";";
    };
    throw cosim_error("nothing moved for " + std::to_string(limit) + " clocks;" + say(in) + say(out) + " clock " +
                      std::to_string(wires_.clocks));
  }

  pure_unit const& unit_;
  int regs_offset_;
  bench_wires wires_;
  link<foreign_word> in_{"in_r"}, out_{"out_r"};
  foreign_device<Model> device_;
  source<foreign_word> source_;
  sink<foreign_word> sink_;
  link_checker<foreign_word> check_in_, check_out_;
  std::vector<unit_words> const* expected_ = nullptr;
  foreign_run result_;
};

}  // namespace relievo::tb
