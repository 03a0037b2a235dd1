// pipeline: drives the Verilated model of a pure pipeline and holds it against the kernel, word by word, with its promised latency.
//
//   pipeline_test<Model, V, Interval = 1>(latency, shape, expected, same = all words, ports = in_i and out_o)   -> clocks that it took
//     Model     Verilated module with clk_i, in_i, out_o and, where V has them, regs_i, map_i, max_generation_i
//     V         stimulus<In, Regs>, or any record of in, regs, map and max_generation
//     shape     as in for_vectors: brings a drawn vector into the unit's domain
//     expected  v -> the kernel's out record
//     same      (rtl, hls) -> AssertionResult, for a unit of whose out record some words say nothing
//     ports     in(model, in), out<Out>(model), for a unit whose words are on ports of other names
//     Interval  initiation interval: clocks from one vector to the next; in the first of them first_i is set, if there is one, and the
//               others have other words at the input
//   Each answer is looked at exactly latency clocks after its vector: a
//   pipeline that is shorter or longer shows another vector's. Registers change between bursts, when the pipeline has drained. Corners
//   first, then rtl_vector_count() random vectors, in a model of their own with the other seed.
#pragma once
#include <verilated.h>

#include <deque>
#include <optional>

#include "tb/cosim/coverage.hpp"
#include "tb/cosim/ports.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {

// A tenth of what the C++ units get.
inline std::uint64_t rtl_vector_count() { return vector_count() / 10; }

namespace detail {

template <class Model, class V>
auto drive_regs(Model& model, V const& v, int) -> decltype(model.regs_i, void()) {
  tb::put(model.regs_i, v.regs);
}
template <class Model, class V>
void drive_regs(Model&, V const&, long) {}

template <class Model, class V>
auto drive_map(Model& model, V const& v, int) -> decltype(model.map_i, v.map, void()) {
  tb::put(model.map_i, v.map);
}
template <class Model, class V>
void drive_map(Model&, V const&, long) {}

template <class Model, class V>
auto drive_max_generation(Model& model, V const& v, int) -> decltype(model.max_generation_i, v.max_generation, void()) {
  tb::put(model.max_generation_i, v.max_generation);
}
template <class Model, class V>
void drive_max_generation(Model&, V const&, long) {}
// All that is constant while words are inside.
template <class Model, class V>
void drive_constants(Model& model, V const& v) {
  drive_regs(model, v, 0);
  drive_map(model, v, 0);
  drive_max_generation(model, v, 0);
}

template <class V>
auto keep_regs(V& v, V const& first, int) -> decltype(v.regs, void()) {
  v.regs = first.regs;
}
template <class V>
void keep_regs(V&, V const&, long) {}
template <class V>
auto keep_map(V& v, V const& first, int) -> decltype(v.map, void()) {
  v.map = first.map;
}
template <class V>
void keep_map(V&, V const&, long) {}
template <class V>
auto keep_max_generation(V& v, V const& first, int) -> decltype(v.max_generation, void()) {
  v.max_generation = first.max_generation;
}
template <class V>
void keep_max_generation(V&, V const&, long) {}
template <class V>
void keep_constants(V& v, V const& first) {
  keep_regs(v, first, 0);
  keep_map(v, first, 0);
  keep_max_generation(v, first, 0);
}

template <class Model>
auto drive_first(Model& model, bool first, int) -> decltype(model.first_i, void()) {
  model.first_i = first;
}
template <class Model>
void drive_first(Model&, bool, long) {}

struct one_port {
  template <class Model, class In>
  void in(Model& model, In const& word) const {
    tb::put(model.in_i, word);
  }
  template <class Out, class Model>
  Out out(Model const& model) const {
    return tb::get<Out>(model.out_o);
  }
};
struct all_words {
  template <class Out>
  testing::AssertionResult operator()(Out const& rtl, Out const& hls) const {
    return same_words(rtl, hls);
  }
};

}  // namespace detail

// One model's part: the corners, or the bursts.
template <class Model, class V, int Interval, class Shape, class Expected, class Same, class Ports>
std::uint64_t pipeline_part(bool corners, generator& g, int latency, Shape shape, Expected expected, Same same, Ports ports) {
  using Out = decltype(expected(std::declval<V const&>()));
  struct pending {
    V v;
    Out out;
  };
  VerilatedContext context;
  context.randReset(2);
  context.randSeed(reset_seed());
  Model model(&context);
  tb::keep_coverage kept(context);
  model.clk_i = 0;
  model.eval();
  // What the pipeline holds, the newest at the back; nothing is expected of a bubble.
  std::deque<std::optional<pending>> inside;
  std::uint64_t clocks = 0;

  const auto clock = [&](std::optional<pending> const& in) {
    inside.push_back(in);
    model.clk_i = 1;
    model.eval();
    model.clk_i = 0;
    model.eval();
    // What it held in the beginning has left.
    if (++clocks >= static_cast<std::uint64_t>(latency)) kept.begin();
    if (inside.size() < static_cast<std::size_t>(latency)) return true;
    const std::optional<pending> done = inside.front();
    inside.pop_front();
    if (!done) return true;
    const auto result = same(ports.template out<Out>(model), done->out);
    if (!result)
      ADD_FAILURE() << "rtl against hls, " << result.message() << "\nclock " << clocks << ", seed " << seed() << ":\n" << describe(done->v);
    return static_cast<bool>(result);
  };
  V other{};
  const auto feed = [&](V const& v) {
    ports.in(model, v.in);
    detail::drive_first(model, true, 0);
    bool passed = clock(pending{v, expected(v)});
    for (int i = 1; i < Interval && passed; ++i) {
      draw_vector(other, draw::uniform, g);
      ports.in(model, other.in);
      detail::drive_first(model, false, 0);
      passed = clock(std::nullopt);
    }
    return passed;
  };
  const auto drain = [&] {
    for (int i = 1; i < latency; ++i)
      if (!clock(std::nullopt)) return false;
    inside.clear();
    return true;
  };

  V v{};
  const std::size_t words = tb::layout<V>().size();
  constexpr int backgrounds[] = {0, 2, 4};
  for (std::size_t at = 0; corners && at < words; ++at)
    for (int corner = 0; corner < corner_count; ++corner)
      for (const int others : backgrounds) {
        corner_vector(v, at, corner, others);
        shape(v, g);
        detail::drive_constants(model, v);
        if (!feed(v) || !drain()) return clocks;
      }
  constexpr std::uint64_t burst = 256;
  for (std::uint64_t done = 0; !corners && done < rtl_vector_count(); done += burst) {
    V first{};
    draw_vector(first, static_cast<draw>(done / burst % 4), g);
    shape(first, g);
    detail::drive_constants(model, first);
    for (std::uint64_t i = 0; i < burst; ++i) {
      draw_vector(v, static_cast<draw>(i % 4), g);
      detail::keep_constants(v, first);
      shape(v, g);
      detail::keep_constants(v, first);
      if (!feed(v)) return clocks;
    }
    if (!drain()) return clocks;
  }
  return clocks;
}

template <class Model, class V, int Interval = 1, class Shape, class Expected, class Same = detail::all_words,
          class Ports = detail::one_port>
std::uint64_t pipeline_test(int latency, Shape shape, Expected expected, Same same = {}, Ports ports = {}) {
  generator g = next_generator();
  const std::uint64_t clocks = pipeline_part<Model, V, Interval>(true, g, latency, shape, expected, same, ports);
  if (testing::Test::HasFailure()) return clocks;
  return clocks + pipeline_part<Model, V, Interval>(false, g, latency, shape, expected, same, ports);
}

}  // namespace relievo::test
