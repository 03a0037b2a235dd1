// map_builder: drives the Verilated model of a builder of maps, texels in and words out, and holds it against the kernel word by word.
//
//   builder_bench<Model, Word> bench(traffic)
//     Model     module with clk_i, rst_ni, busy_o, map_i, in_valid_i/in_ready_o/in_i (a texel) and out_valid_o/out_ready_i/out_o
//     Word      record of what comes out
//   bench.build(map, texels, expected)   -> clocks from the first texel taken to the last word out, or 0 after a failure
//                                        one map, or several of the same registers behind each other; other registers than map are
//                                        put on bench.model before. The first texel is offered in the clock after busy_o has fallen.
//   bench.interrupt(map, texels, clocks) some clocks of a map and a reset
//   bench.rest()                         some clocks more: nothing comes out, nothing is busy
//   Checked besides the words: out holds while it is not taken, busy_o stands exactly from the clock after the first texel to the last
//   word, all texels are taken, and a watchdog of 10,000 clocks without a word.
#pragma once
#include <memory>
#include <string>

#include "tests/support/maps.hpp"
#include "tests/support/stream_unit.hpp"

namespace relievo::test {

template <class Model, class Word>
class builder_bench {
 public:
  explicit builder_bench(traffic const& t) : context_(make_context()), model(context_.get()), traffic_(t), g_(next_generator()) {
    model.clk_i = 0;
    reset();
  }

  void reset() {
    model.rst_ni = 0;
    model.in_valid_i = 0;
    model.out_ready_i = 0;
    for (int i = 0; i < 4; ++i) {
      edge();
      kept_.begin();
    }
    model.rst_ni = 1;
  }

  std::uint64_t build(hls::map_regs const& map, std::vector<std::uint16_t> const& texels, std::vector<Word> const& expected) {
    tb::put(model.map_i, map);
    std::uint64_t clocks = 0, first = 0, last = 0, quiet = 0;
    std::size_t sent = 0, received = 0;
    bool offered = false, held = false;
    Word held_word{};
    while (received < expected.size() || sent < texels.size()) {
      if (!offered && sent < texels.size() && g_.below(16) >= traffic_.idle) {
        model.in_i = texels[sent];
        offered = true;
      }
      // What lies on the port of the texels when none is offered does not matter.
      if (!offered) model.in_i = static_cast<std::uint16_t>(g_() & 0xffff);
      model.in_valid_i = offered;
      model.out_ready_i = g_.below(16) >= traffic_.stall;
      model.eval();
      if ((model.busy_o != 0) != (sent > 0)) return failed("busy_o is " + std::to_string(model.busy_o), sent, received);
      if (held && !model.out_valid_o) return failed("out_valid fell before the word was taken", sent, received);
      const bool leaves = model.out_valid_o && model.out_ready_i;
      if (model.out_valid_o) {
        const Word word = tb::get<Word>(model.out_o);
        if (received == expected.size()) return failed("a word too many", sent, received);
        const auto result = same_words(word, expected[received]);
        if (!result) return failed(std::string("rtl against hls, ") + result.message(), sent, received);
        if (held && !same_words(word, held_word)) return failed("out changed while it was not taken", sent, received);
        held_word = word;
      }
      held = model.out_valid_o && !leaves;
      if (leaves) {
        last = clocks;
        ++received;
      }
      const bool taken = offered && model.in_ready_o;
      if (taken) {
        if (sent == 0) first = clocks;
        ++sent;
        offered = false;
      }
      quiet = taken || leaves ? 0 : quiet + 1;
      if (quiet > 10000) return failed("nothing moved for 10,000 clocks", sent, received);
      edge();
      ++clocks;
    }
    return last - first + 1;
  }

  // A map that a reset ends after some clocks.
  void interrupt(hls::map_regs const& map, std::vector<std::uint16_t> const& texels, int clocks) {
    tb::put(model.map_i, map);
    for (int i = 0; i < clocks; ++i) {
      model.in_valid_i = 1;
      model.in_i = texels[static_cast<std::size_t>(i) % texels.size()];
      model.out_ready_i = g_.chance(2);
      edge();
    }
    reset();
  }

  void rest() {
    model.in_valid_i = 0;
    model.out_ready_i = 1;
    for (int i = 0; i < 100; ++i) {
      model.eval();
      ASSERT_FALSE(model.out_valid_o) << "a word that nobody asked for";
      ASSERT_FALSE(model.busy_o);
      edge();
    }
  }

 private:
  static std::unique_ptr<VerilatedContext> make_context() {
    auto context = std::make_unique<VerilatedContext>();
    context->randReset(2);
    context->randSeed(reset_seed());
    return context;
  }
  void edge() {
    model.clk_i = 1;
    model.eval();
    model.clk_i = 0;
    model.eval();
  }
  static std::uint64_t failed(std::string const& what, std::size_t sent, std::size_t received) {
    ADD_FAILURE() << what << "\nafter " << sent << " texels in and " << received << " words out, seed " << seed();
    return 0;
  }

  std::unique_ptr<VerilatedContext> context_;

 public:
  Model model;

 private:
  tb::keep_coverage kept_{*context_};
  traffic traffic_;
  generator g_;
};

// {no idle, idle} x {no stall, stall}.
inline std::vector<traffic> builder_traffic() {
  std::vector<traffic> list;
  for (const std::uint64_t idle : {0, 7})
    for (const std::uint64_t stall : {0, 7}) list.push_back({idle, stall, 1, 1});
  return list;
}

}  // namespace relievo::test
