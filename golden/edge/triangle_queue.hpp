// triangle_queue: triangles waiting for their next pass.                        Doggett & Hirche 2000, section 3 (Triangle Queue)
//
//   regs  fifo   the paper's order, oldest first, while the storage allows it; otherwise newest first
//
// Newest first, one triangle alone never leaves more than 3 max_generation entries above where it began. A fifo pop
// therefore happens only when, after it, 3 max_generation + 4 places are free; else the newest is taken (a fallback).
// Nothing is ever dropped: a push beyond the capacity throws std::length_error, and 3 max_generation + 4 entries never do.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <stdexcept>

#include "golden/edge/triangle.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct triangle_queue_regs {
  bool fifo = false;
  RELIEVO_FIELDS(fifo)
};

class triangle_queue {
 public:
  triangle_queue(std::size_t capacity, triangle_queue_regs const& regs, double max_generation)
      : capacity_(capacity), fifo_(regs.fifo), reserve_(3 * static_cast<std::size_t>(max_generation) + 4) {}

  bool empty() const { return waiting_.empty(); }
  std::uint64_t high_water() const { return high_water_; }
  std::uint64_t fallbacks() const { return fallbacks_; }

  void push(triangle const& t) {
    if (waiting_.size() == capacity_) throw std::length_error("triangle_queue: more triangles than entries");
    waiting_.push_back(t);
    high_water_ = std::max<std::uint64_t>(high_water_, waiting_.size());
  }

  triangle pop() {
    const std::size_t free = capacity_ - waiting_.size();
    const bool oldest = fifo_ && free + 1 >= reserve_;
    if (fifo_ && !oldest) ++fallbacks_;
    const triangle t = oldest ? waiting_.front() : waiting_.back();
    if (oldest)
      waiting_.pop_front();
    else
      waiting_.pop_back();
    return t;
  }

 private:
  std::size_t capacity_;
  bool fifo_;
  std::size_t reserve_;
  std::deque<triangle> waiting_;
  std::uint64_t high_water_ = 0;
  std::uint64_t fallbacks_ = 0;
};

}  // namespace golden
}  // namespace relievo
