#include "Vengine_small.h"
#include "tb/cosim/engine_bench_of.hpp"
#include "tests/cosim/engines.hpp"

namespace relievo::test {
void add_small_engine() { tb::add_engine_variant("small", tb::engine_of<Vengine_small, 1, 3, 1>()); }
}  // namespace relievo::test
