// random: the one source of random numbers of the unit tests, seeded, the same on every machine.
//
//   generator g(salt)   its own sequence for every run's seed and every salt (tests use their own name)
//   reset_seed()        what a model's registers hold before reset: one of two seeds, now this one, now that, a model each
//   g()                 64 random bits;  g.below(n) 0..n-1;  g.between(a, b) a..b;  g.chance(n) one time in n
#pragma once
#include <cstdint>
#include <string_view>

#include "tests/support/settings.hpp"

namespace relievo::test {

// splitmix64: passes the usual batteries, one multiplication chain, any seed is a good one.
class generator {
 public:
  explicit generator(std::string_view salt) : state_(seed() * 0x9e3779b97f4a7c15u) {
    for (const char c : salt) state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }

  std::uint64_t operator()() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  // The bias of a remainder is below n / 2^64.
  std::uint64_t below(std::uint64_t n) { return (*this)() % n; }
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
  }
  bool chance(std::uint64_t n) { return below(n) == 0; }

 private:
  std::uint64_t state_;
};

// By the parity of the bits of how many there were, so that neither seed goes with one of the kinds of traffic that a test runs in turn.
inline int reset_seed() {
  static unsigned made = 0;
  unsigned parity = made++;
  for (int shift = 16; shift > 0; shift /= 2) parity ^= parity >> shift;
  return static_cast<int>((seed() + 4711 * (parity & 1)) & 0x7fffffff) + 1;
}

}  // namespace relievo::test
