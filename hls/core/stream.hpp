// stream: a bounded first-in first-out channel with the subset that hls::stream and ac_channel share.
//   Kernels use read() and write() alone; empty(), full() and size() belong to the bench.
//   In simulation a write to a full stream or a read from an empty one is a bug of the caller: it is reported by the stream's name
//   and ends the program, and words left over when a stream dies are reported too.
#pragma once
#include "hls/core/synthesis.hpp"

#ifndef RELIEVO_SYNTHESIS
#include <cstdio>
#include <cstdlib>
#endif

namespace relievo {
namespace hls {

template <class T, int Depth = 2>
class stream {
  static_assert(Depth >= 1, "a stream holds at least one word");

 public:
#ifdef RELIEVO_SYNTHESIS
  stream() = default;
#else
  explicit stream(char const* name = "stream") : name_(name) {}
  ~stream() {
    if (count_ != 0) std::fprintf(stderr, "%s: %d words left over\n", name_, count_);
  }
  stream(stream const&) = delete;
  stream& operator=(stream const&) = delete;
#endif

  bool empty() const { return count_ == 0; }
  bool full() const { return count_ == Depth; }
  int size() const { return count_; }

  void write(T const& word) {
#ifndef RELIEVO_SYNTHESIS
    if (full()) fail("write to a full stream: no forward progress until it is read");
#endif
    words_[(first_ + count_) % Depth] = word;
    ++count_;
  }
  T read() {
#ifndef RELIEVO_SYNTHESIS
    if (empty()) fail("read from an empty stream: no forward progress until it is written");
#endif
    const T word = words_[first_];
    first_ = (first_ + 1) % Depth;
    --count_;
    return word;
  }

 private:
  T words_[Depth];
  int first_ = 0;
  int count_ = 0;
#ifndef RELIEVO_SYNTHESIS
  [[noreturn]] void fail(char const* what) const {
    std::fprintf(stderr, "%s: %s\n", name_, what);
    std::abort();
  }
  char const* name_;
#endif
};

}  // namespace hls
}  // namespace relievo
