// progress: a bar on stderr for work that lasts. Silent unless stderr is a terminal, and silent for the first second, so
// short work and logs never see it. The bar is wiped when the object goes.
//
//   progress bar("measuring", samples);
//   for (...) bar.advance();
#pragma once
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

namespace relievo::tb {

class progress {
 public:
  progress(std::string label, std::uint64_t total) : label_(std::move(label)), total_(total), terminal_(isatty(STDERR_FILENO) == 1) {}
  progress(progress const&) = delete;
  progress& operator=(progress const&) = delete;
  ~progress() {
    if (shown_) std::fputs("\r\x1b[K", stderr);
  }

  void advance(std::uint64_t steps = 1) { set(done_ + steps); }

  // A clock reading costs more than most steps do, so only every 16th call looks at it.
  void set(std::uint64_t done) {
    done_ = done;
    if (!terminal_ || (++calls_ & 15u) != 0) return;
    draw();
  }

 private:
  using clock = std::chrono::steady_clock;

  void draw() {
    const auto now = clock::now();
    if (now - start_ < std::chrono::seconds(1) || now - drawn_ < std::chrono::milliseconds(100)) return;
    drawn_ = now;
    shown_ = true;
    if (total_ == 0) {
      std::fprintf(stderr, "\r\x1b[K%s %llu", label_.c_str(), static_cast<unsigned long long>(done_));
    } else {
      constexpr int width = 40;
      const double part = done_ >= total_ ? 1.0 : static_cast<double>(done_) / static_cast<double>(total_);
      const int filled = static_cast<int>(part * width);
      const std::string bar =
          std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(width - filled), '.');
      std::fprintf(stderr, "\r\x1b[K%s [%s] %3d %%", label_.c_str(), bar.c_str(), static_cast<int>(part * 100.0));
    }
    std::fflush(stderr);
  }

  std::string label_;
  std::uint64_t total_;
  std::uint64_t done_ = 0;
  std::uint64_t calls_ = 0;
  bool terminal_;
  bool shown_ = false;
  clock::time_point start_ = clock::now();
  clock::time_point drawn_ = start_;
};

}  // namespace relievo::tb
