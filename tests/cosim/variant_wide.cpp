#include "Vengine_wide.h"
#include "tb/cosim/engine_bench_of.hpp"
#include "tests/cosim/engines.hpp"

namespace relievo::test {
void add_wide_engine() { tb::add_engine_variant("wide", tb::engine_of<Vengine_wide, 3, 12, 4>()); }
}  // namespace relievo::test
