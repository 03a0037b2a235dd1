// main of relievo_benchmark: Google Benchmark's, with the line that SystemC's library wants to see, and the settings of the unit benches.
#include <benchmark/benchmark.h>

#include "tests/support/settings.hpp"

namespace relievo::test {
settings& current_settings() {
  static settings s;
  return s;
}
}  // namespace relievo::test

extern "C" int sc_main(int, char**);
int sc_main(int, char**) { return 0; }

BENCHMARK_MAIN();
