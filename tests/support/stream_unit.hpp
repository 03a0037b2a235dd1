// stream_unit: drives the Verilated model of a unit with valid/ready streams, and with read ports of map memories, and holds it against
// the kernel word by word in order.
//
//   stream_test<Model, V>(traffic, shape, expected, {ports...}, count, same = all words)
//     -> clocks from the first word taken to the last word out
//     Model     module with clk_i, rst_ni, in_valid_i/in_ready_o/in_i, out_valid_o/out_ready_i/out_o and, where V has them, regs_i, map_i
//     V         record of in, regs, map, max_generation (any subset with in)
//     expected  v -> the kernel's out record, or a std::vector of those that follow each other
//     same      (rtl, hls) -> AssertionResult, where the kernel says nothing of some words
//     ports     read ports of map memories, made by RELIEVO_MEMORY_PORT(Model, prefix, Request, answer) with
//               <prefix>_req_valid_o, _req_ready_i, _req_o, _rsp_valid_i, _rsp_i; answer: Request record -> record of the answer
//   traffic     how often a source idles and a sink stalls, in sixteenths, and the latency of the memories, fixed or random; they also
//               refuse requests as often as the sink stalls
//   all_traffic() is {no idle, idle} x {no stall, stall} x {latency 1, random}.
//   The registers are drawn once a call. in_i and the answers carry random bits while they are not valid. Before the reset the unit is
//   fed, answered and stalled at random, so that whatever is valid in it must be forgotten. Checked besides the words: out holds while
//   it is not taken, nothing comes out for which nothing went in, nothing stays behind, neither a ready nor in_valid_i reaches another
//   ready or valid within a clock, and a watchdog of 10,000 clocks without a word.
#pragma once
#include <verilated.h>

#include <deque>
#include <functional>
#include <vector>

#include "tests/support/pipeline.hpp"

namespace relievo::test {

struct traffic {
  std::uint64_t idle, stall;               // sixteenths
  std::int64_t latency_low, latency_high;  // clocks from a request to its answer, 1 at least
};

inline std::vector<traffic> all_traffic() {
  std::vector<traffic> list;
  for (const std::uint64_t idle : {0, 7})
    for (const std::uint64_t stall : {0, 7})
      for (const std::int64_t latency : {1, 40}) list.push_back({idle, stall, 1, latency});
  return list;
}

template <class Model>
struct memory_port {
  std::function<bool(Model const&)> moves;  // valid and ready: a request is taken at the coming edge
  std::function<void(Model&, bool)> set_ready;
  std::function<std::function<void(Model&)>(Model const&)> answer;  // the request of now -> what puts its answer on the port
  std::function<void(Model&, bool)> set_valid;
  std::function<void(Model&, generator&)> scramble;  // any word on the port while it answers nothing
  std::function<bool(Model const&)> asks;            // a request is valid
};

#define RELIEVO_MEMORY_PORT(Model, prefix, Request, answer_of)                               \
  ::relievo::test::memory_port<Model> {                                                      \
    [](Model const& m) { return m.prefix##_req_valid_o && m.prefix##_req_ready_i; },         \
        [](Model& m, bool ready) { m.prefix##_req_ready_i = ready; },                        \
        [=](Model const& m) -> std::function<void(Model&)> {                                 \
          const auto response = answer_of(::relievo::tb::get<Request>(m.prefix##_req_o));    \
          return [response](Model& to) { ::relievo::tb::put(to.prefix##_rsp_i, response); }; \
        },                                                                                   \
        [](Model& m, bool valid) { m.prefix##_rsp_valid_i = valid; },                        \
        [=](Model& m, ::relievo::test::generator& g) {                                       \
          decltype(answer_of(Request{})) any{};                                              \
          draw_vector(any, ::relievo::test::draw::uniform, g);                               \
          ::relievo::tb::put(m.prefix##_rsp_i, any);                                         \
        },                                                                                   \
        [](Model const& m) { return m.prefix##_req_valid_o != 0; }                           \
  }

namespace detail {

template <class Out>
std::vector<Out> words_of(Out const& word) {
  return {word};
}
template <class Out>
std::vector<Out> words_of(std::vector<Out> const& words) {
  return words;
}

}  // namespace detail

template <class Model, class V, class Shape, class Expected, class Same = detail::all_words>
std::uint64_t stream_test(traffic const& t, Shape shape, Expected expected, std::vector<memory_port<Model>> const& ports,
                          std::uint64_t count, Same same = {}) {
  using Out = typename decltype(detail::words_of(expected(std::declval<V const&>())))::value_type;
  struct answer {
    std::uint64_t due;
    std::function<void(Model&)> put;
  };
  VerilatedContext context;
  context.randReset(2);
  context.randSeed(reset_seed());
  Model model(&context);
  tb::keep_coverage kept(context);
  generator g = next_generator();
  std::vector<std::deque<answer>> answers(ports.size());
  std::deque<std::pair<V, Out>> waiting;
  std::uint64_t clocks = 0, sent = 0, first = 0, last = 0, quiet = 0;

  V v{};
  draw_vector(v, draw::uniform, g);
  shape(v, g);
  const V constants = v;
  detail::drive_constants(model, v);
  model.clk_i = 0;
  const auto edge = [&] {
    model.clk_i = 1;
    model.eval();
    model.clk_i = 0;
    model.eval();
  };
  model.rst_ni = 1;
  model.in_valid_i = 1;
  for (int i = 0; i < 40; ++i) {
    model.out_ready_i = g.chance(2);
    draw_vector(v.in, draw::uniform, g);
    tb::put(model.in_i, v.in);
    for (auto const& p : ports) {
      p.set_ready(model, g.chance(2));
      p.set_valid(model, g.chance(2));
      p.scramble(model, g);
    }
    edge();
  }
  model.rst_ni = 0;
  model.in_valid_i = 0;
  model.out_ready_i = 0;
  for (auto const& p : ports) {
    p.set_ready(model, false);
    p.set_valid(model, false);
  }
  for (int i = 0; i < 4; ++i) {
    edge();
    kept.begin();
  }
  model.rst_ni = 1;

  // What the unit says on its links.
  const auto said = [&] {
    std::vector<bool> list = {model.in_ready_o != 0, model.out_valid_o != 0};
    for (auto const& p : ports) list.push_back(p.asks(model));
    return list;
  };
  std::vector<bool> readies(ports.size());
  bool offered = false, held = false;
  Out held_out{};
  const auto all_out = [&] { return sent == count && waiting.empty(); };
  // Some clocks more than there are words: nothing may follow the last.
  for (std::uint64_t after = 0; after < 300; after += all_out() ? 1 : 0) {
    if (!offered && sent < count && g.below(16) >= t.idle) {
      draw_vector(v, static_cast<draw>(g.below(4)), g);
      detail::keep_constants(v, constants);
      shape(v, g);
      detail::keep_constants(v, constants);
      tb::put(model.in_i, v.in);
      offered = true;
    }
    // What is not valid is not looked at.
    if (!offered) {
      V any{};
      draw_vector(any, draw::uniform, g);
      tb::put(model.in_i, any.in);
    }
    model.in_valid_i = offered;
    const bool out_ready = g.below(16) >= t.stall;
    model.out_ready_i = out_ready;
    for (std::size_t i = 0; i < ports.size(); ++i) {
      readies[i] = g.below(16) >= t.stall;
      ports[i].set_ready(model, readies[i]);
      const bool due = !answers[i].empty() && answers[i].front().due <= clocks;
      ports[i].set_valid(model, due);
      if (due) {
        answers[i].front().put(model);
        answers[i].pop_front();
      } else {
        ports[i].scramble(model, g);
      }
    }
    model.eval();
    // With every ready and in_valid_i turned round for a moment the unit says the same.
    if (clocks % 3 == 0) {
      const std::vector<bool> before = said();
      model.in_valid_i = !offered;
      model.out_ready_i = !out_ready;
      for (std::size_t i = 0; i < ports.size(); ++i) ports[i].set_ready(model, !readies[i]);
      model.eval();
      if (said() != before) {
        ADD_FAILURE() << "a ready or in_valid reaches in_ready, out_valid or a request within the clock, clock " << clocks;
        return 0;
      }
      model.in_valid_i = offered;
      model.out_ready_i = out_ready;
      for (std::size_t i = 0; i < ports.size(); ++i) ports[i].set_ready(model, readies[i]);
      model.eval();
    }

    // What moves at the coming edge.
    const bool taken = offered && model.in_ready_o;
    const bool leaves = model.out_valid_o && model.out_ready_i;
    for (std::size_t i = 0; i < ports.size(); ++i) {
      if (ports[i].moves(model)) {
        std::uint64_t due = clocks + static_cast<std::uint64_t>(g.between(t.latency_low, t.latency_high));
        if (!answers[i].empty() && answers[i].back().due >= due) due = answers[i].back().due + 1;
        answers[i].push_back({due, ports[i].answer(model)});
      }
    }
    if (model.out_valid_o) {
      const Out out = tb::get<Out>(model.out_o);
      if (held && !same_words(out, held_out)) {
        ADD_FAILURE() << "out changed while it was not taken, " << same_words(out, held_out).message() << ", clock " << clocks;
        return 0;
      }
      held_out = out;
    } else if (held) {
      ADD_FAILURE() << "out_valid fell before the word was taken, clock " << clocks;
      return 0;
    }
    held = model.out_valid_o && !leaves;
    if (leaves) {
      if (waiting.empty()) {
        ADD_FAILURE() << "a word came out for which none went in, clock " << clocks;
        return 0;
      }
      const auto result = same(tb::get<Out>(model.out_o), waiting.front().second);
      if (!result) {
        ADD_FAILURE() << "rtl against hls, " << result.message() << "\nclock " << clocks << ", seed " << seed() << ":\n"
                      << describe(waiting.front().first);
        return 0;
      }
      waiting.pop_front();
      last = clocks;
    }
    if (taken) {
      if (sent == 0) first = clocks;
      for (Out const& out : detail::words_of(expected(v))) waiting.push_back({v, out});
      ++sent;
      offered = false;
    }
    quiet = taken || leaves || all_out() ? 0 : quiet + 1;
    if (quiet > 10000) {
      ADD_FAILURE() << "nothing moved for 10,000 clocks: " << sent << " words in, " << waiting.size() << " not out";
      return 0;
    }
    edge();
    ++clocks;
  }
  for (auto const& list : answers)
    if (!list.empty()) ADD_FAILURE() << list.size() << " requests more than the words needed";
  return last - first + 1;
}

}  // namespace relievo::test
