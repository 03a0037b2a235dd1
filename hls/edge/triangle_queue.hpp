// triangle_queue: where triangles wait for their next pass.
//   Doggett & Hirche 2000, section 3, Triangle Queue
//   lifo (default)  the newest triangle first: depth first, at most 3 entries more per generation
//   fifo            the paper's mode: the oldest first while the storage can still take a whole depth-first descent, else the newest
//                   (a fallback, counted)
//   Depth >= 3 max_generation + 4 and nothing in flight but the triangle popped: it never fills. Proof: popped depth first, a
//   triangle leaves at most 3 entries above where it began at each of its max_generation generations, and a fifo pop is taken only
//   while 3 max_generation + 4 entries would be free with it.
//   one push or pop a clock
#pragma once
#include "hls/edge/triangle.hpp"
#ifndef RELIEVO_SYNTHESIS
#include <cstdio>
#include <cstdlib>
#endif

namespace relievo {
namespace hls {

struct triangle_queue_regs {
  bool fifo;
  RELIEVO_FIELDS(fifo)
};

template <int Depth>
class triangle_queue {
  static_assert(Depth >= 4, "a triangle may return four");

 public:
  bool empty() const { return count_ == 0; }
  int high_water() const { return high_water_; }
  void start() { first_ = count_ = high_water_ = 0; }

  // Never called on a full queue by an engine whose depth satisfies the rule above; in simulation that is checked.
  void push(triangle const& t) {
#ifndef RELIEVO_SYNTHESIS
    if (count_ == Depth) {
      std::fprintf(stderr, "triangle_queue: push on a full queue of %d entries; 3 max_generation + 4 are needed\n", Depth);
      std::abort();
    }
#endif
    entry_[wrap(first_ + count_)] = t;
    ++count_;
    if (count_ > high_water_) high_water_ = count_;
  }

  // fallback |= fifo was asked for and the newest was taken
  triangle pop(triangle_queue_regs const& regs, fixed<formats::generation> max_generation, bool& fallback) {
    const bool oldest = regs.fifo && Depth - count_ + 1 >= 3 * raw(max_generation) + 4;
    fallback = regs.fifo && !oldest;
    --count_;
    const int at = oldest ? first_ : wrap(first_ + count_);
    if (oldest) first_ = wrap(first_ + 1);
    return entry_[at];
  }

 private:
  static int wrap(int place) { return place >= Depth ? place - Depth : place; }
  triangle entry_[Depth];
  int first_ = 0;
  int count_ = 0;
  int high_water_ = 0;
};

}  // namespace hls
}  // namespace relievo
