// The engine: edge tests a second on the Jacksboro terrain over 128 base triangles, about 20,000 triangles out, with the paper's four tests
// and with the profile test too. Items are edge tests; the counter says how many triangles came out.
#include <benchmark/benchmark.h>

#include "tb/model/model.hpp"
#include "tests/support/jacksboro.hpp"

namespace relievo::bench {
namespace {

void run_engine(benchmark::State& state, tb::scene_options const& options) {
  const tb::scene scene = tb::make_scene(options);
  const auto model = tb::make_model("hls", scene);
  std::uint64_t tests = 0;
  golden::counters counts;
  for (auto _ : state) {
    counts = model->run({});
    tests += counts.edge_tests;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(tests));
  state.counters["triangles"] = static_cast<double>(counts.triangles_out);
  state.counters["edge_tests"] = static_cast<double>(counts.edge_tests);
}

void engine_paper_tests(benchmark::State& state) { run_engine(state, test::jacksboro()); }
BENCHMARK(engine_paper_tests)->Unit(benchmark::kMillisecond);

void engine_with_profile(benchmark::State& state) {
  tb::scene_options options = test::jacksboro();
  options.tests.pt = true;
  options.normal_threshold = 1.2;
  options.height_threshold = 80000;
  options.profile_threshold = 23;
  run_engine(state, options);
}
BENCHMARK(engine_with_profile)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace relievo::bench
