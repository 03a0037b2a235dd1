// rejected: not an addition
// A vertex of an edge by multiplying the step, in a function that the inner loop calls.
#include <cstdint>

#include "hls/core/additions_only.hpp"

namespace {
std::int32_t vertex_of(std::int32_t i, std::int32_t step) { return i * step; }
}  // namespace

std::int32_t edge_multiplication(std::int32_t from, std::int32_t i, std::int32_t step) {
  RELIEVO_ADDITIONS_ONLY("the inner loop");
  return from + vertex_of(i, step);
}
