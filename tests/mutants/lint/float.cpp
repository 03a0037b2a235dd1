// rejected: float
// A threshold scaled in floating point on its way in.
#include <cstdint>

bool normal_test_float(std::int32_t difference, std::int32_t threshold) {
  return static_cast<float>(difference) > 0.5F * static_cast<float>(threshold);
}
