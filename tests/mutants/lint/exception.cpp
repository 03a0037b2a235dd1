// rejected: exception
// A division that complains instead of saturating.
#include <cstdint>

std::int64_t divide_exception(std::int64_t numerator, std::int64_t denominator) {
  if (denominator == 0) throw denominator;
  return numerator / denominator;
}
