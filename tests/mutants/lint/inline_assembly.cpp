// rejected: inline assembly
// A leading-zero count of one processor.
#include <cstdint>

std::uint64_t normalize_assembly(std::uint64_t square) {
  std::uint64_t zeros;
  asm("lzcnt %1, %0" : "=r"(zeros) : "r"(square));
  return zeros;
}
