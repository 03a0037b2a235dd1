// rejected: unbounded loop
// The only bound is the width of the counter: 2^32 turns.
#include <cstdint>

std::uint64_t summed_rows(std::uint64_t const* rows, std::uint32_t height) {
  std::uint64_t sum = 0;
  for (std::uint32_t y = 0; y < height; ++y) sum += rows[y];
  return sum;
}
