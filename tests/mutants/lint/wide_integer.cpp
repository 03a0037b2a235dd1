// rejected: wide integer
// A product of 24-bit and 52-bit words that needs more than 64 bits.
#include <cstdint>

std::int64_t transform_wide(std::int64_t p, std::int64_t row) { return static_cast<std::int64_t>((static_cast<__int128>(p) * row) >> 64); }
