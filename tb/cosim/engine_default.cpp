// The engine as the command line runs it: one lane, twelve words of the table and four samples of a profile a clock.
#include "Vengine.h"
#include "tb/cosim/engine_bench_of.hpp"

namespace relievo::tb {
void add_default_engine() { add_engine_variant("default", engine_of<Vengine, 1, 12, 4>()); }
}  // namespace relievo::tb
