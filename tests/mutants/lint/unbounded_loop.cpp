// rejected: unbounded loop
// A divider by repeated subtraction: it ends, but when depends on the data.
#include <cstdint>

std::int32_t divide_unbounded(std::int64_t numerator, std::int64_t denominator) {
  std::int32_t quotient = 0;
  while (numerator >= denominator) {
    numerator -= denominator;
    ++quotient;
  }
  return quotient;
}
