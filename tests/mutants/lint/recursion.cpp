// rejected: recursion
// The paper's tessellation as it is drawn, calling itself for the halves of an edge.
#include <cstdint>

namespace {
std::int32_t right_half(std::int32_t length, std::int32_t generation);
std::int32_t left_half(std::int32_t length, std::int32_t generation) {
  return length < 2 || generation == 0 ? 1 : right_half(length / 2, generation - 1) + 1;
}
std::int32_t right_half(std::int32_t length, std::int32_t generation) {
  return length < 2 || generation == 0 ? 1 : left_half(length - length / 2, generation - 1) + 1;
}
}  // namespace

std::int32_t tessellate_recursion(std::int32_t length, std::int32_t generation) { return left_half(length, generation); }
