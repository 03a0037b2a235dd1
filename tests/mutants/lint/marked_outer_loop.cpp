// rejected: unbounded loop
// A streaming loop is exempt itself; what it contains is not.
#include <cstdint>

#include "hls/core/streaming_loop.hpp"

void engine_marked(std::uint32_t const* in, std::uint32_t* out) {
  for (std::uint32_t i = 0; in[i] != 0; ++i) {
    RELIEVO_STREAMING_LOOP("one turn per triangle");
    std::uint32_t steps = 0;
    for (std::uint32_t word = in[i]; word != 1; word = word % 2 == 0 ? word / 2 : 3 * word + 1) ++steps;
    out[i] = steps;
  }
}
