#include "Vengine_foreign.h"
#include "Vengine_four.h"
#include "Vengine_narrow.h"
#include "Vengine_three.h"
#include "tb/cosim/engine_bench_of.hpp"
#include "tests/cosim/engines.hpp"

namespace relievo::test {
void add_campaign_engines() {
  tb::add_engine_variant("narrow", tb::engine_of<Vengine_narrow, 1, 1, 1>());
  tb::add_engine_variant("three", tb::engine_of<Vengine_three, 1, 3, 1>());
  tb::add_engine_variant("four", tb::engine_of<Vengine_four, 1, 4, 16>());
  tb::add_engine_variant("foreign", tb::engine_of<Vengine_foreign, 1, 12, 4>());
}
}  // namespace relievo::test
