// Circuits: clocks a second of the engine on the Jacksboro terrain, in its SystemC bench and in a bare loop around the same Verilated
// model, and of the unit bench of displace. Items are clocks. `small` stops at the second generation, for a test of the ratio.
#include <benchmark/benchmark.h>

#include <optional>

#include "Vdisplace.h"
#include "Vengine.h"
#include "hls/surface/displace.hpp"
#include "tb/model/hls_words.hpp"
#include "tests/support/engine_loop.hpp"
#include "tests/support/engine_words.hpp"
#include "tests/support/jacksboro.hpp"
#include "tests/support/pipeline.hpp"

namespace relievo::bench {
namespace {

// The scene in the circuit's words.
class circuit_scene {
 public:
  explicit circuit_scene(std::optional<int> max_generation)
      : scene_(make(max_generation)), words_(scene_), base_(test::base_words(words_.triangles())) {}
  tb::cosim_scene words() const { return {words_.regs(), &base_, words_.memories()}; }

 private:
  static tb::scene make(std::optional<int> max_generation) {
    tb::scene_options options = test::jacksboro();
    options.max_generation = max_generation;
    return tb::make_scene(options);
  }
  tb::scene scene_;
  tb::hls_words words_;
  std::vector<hls::port_word<hls::top::base_triangle>> base_;
};

void report(benchmark::State& state, std::uint64_t clocks, std::uint64_t triangles) {
  state.SetItemsProcessed(static_cast<std::int64_t>(clocks));
  state.counters["triangles"] = static_cast<double>(triangles);
}

// SystemC elaborates one bench a process: every round runs in the same one.
void circuit_systemc(benchmark::State& state, std::optional<int> max_generation) {
  tb::add_default_engine();
  tb::engine_bench& bench = tb::the_engine_bench({});
  const circuit_scene scene(max_generation);
  std::uint64_t clocks = 0, triangles = 0;
  for (auto _ : state) {
    triangles = 0;
    clocks += bench.run(scene.words(), [&](hls::triangle_out const&) { ++triangles; }).clocks;
  }
  report(state, clocks, triangles);
}
BENCHMARK_CAPTURE(circuit_systemc, jacksboro, std::nullopt)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(circuit_systemc, small, 2)->Unit(benchmark::kMillisecond);

void circuit_loop(benchmark::State& state, std::optional<int> max_generation) {
  test::engine_loop<Vengine, 12, 4> loop;
  const circuit_scene scene(max_generation);
  std::uint64_t clocks = 0, triangles = 0;
  for (auto _ : state) {
    triangles = 0;
    clocks += loop.run(scene.words(), {}, [&](hls::triangle_out const&) { ++triangles; });
  }
  report(state, clocks, triangles);
}
BENCHMARK_CAPTURE(circuit_loop, jacksboro, std::nullopt)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(circuit_loop, small, 2)->Unit(benchmark::kMillisecond);

// The bench that tests/surface/displace_rtl.cpp runs, kernel and comparison included.
void circuit_displace(benchmark::State& state) {
  std::uint64_t clocks = 0;
  for (auto _ : state)
    clocks += test::pipeline_test<Vdisplace, test::stimulus<hls::displace_in, hls::displace_regs>>(
        10, test::any_word(), [](auto const& v) { return hls::displace(v.in, v.regs); });
  state.SetItemsProcessed(static_cast<std::int64_t>(clocks));
}
BENCHMARK(circuit_displace)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace relievo::bench
