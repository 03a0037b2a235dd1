// pacer: says each clock whether a source offers or a sink takes a word. One object, one probability, one seed on every end of every link.
#pragma once
#include <cstdint>
#include <random>

namespace relievo::tb {

class pacer {
 public:
  // rest: how often it does nothing, in percent, 0..99.
  pacer(int rest, std::uint64_t seed) : rest_(rest), random_(seed) {}
  bool go() { return rest_ == 0 || static_cast<int>(random_() % 100) >= rest_; }

 private:
  int rest_;
  std::minstd_rand random_;
};

}  // namespace relievo::tb
