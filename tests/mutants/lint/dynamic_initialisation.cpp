// rejected: dynamic initialisation
// A table that is filled when the program starts, which a circuit never does.
#include <cstdint>

namespace {
struct table {
  table() {
    for (std::uint32_t i = 0; i < 256; ++i) entry[i] = seed * i;
  }
  static volatile std::uint32_t seed;
  std::uint32_t entry[256];
};
volatile std::uint32_t table::seed = 3;
const table reciprocals;
}  // namespace

std::uint32_t reciprocal_initialised(std::uint32_t i) { return reciprocals.entry[i & 255]; }
