// main of relievo_benchmark: Google Benchmark's, with the line that SystemC's library wants to see.
#include <benchmark/benchmark.h>

extern "C" int sc_main(int, char**);
int sc_main(int, char**) { return 0; }

BENCHMARK_MAIN();
