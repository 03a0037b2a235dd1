// rejected: heap
// A queue that grows.
#include <cstdint>

std::int64_t triangle_queue_heap(std::int32_t entries) {
  auto* queue = new std::int64_t[static_cast<unsigned>(entries)];
  queue[0] = entries;
  const std::int64_t newest = queue[0];
  delete[] queue;
  return newest;
}
