// settings: the seed and the number of random vectors of this run (tests/support/main.cpp).
#pragma once
#include <cstdint>

namespace relievo::test {
struct settings {
  std::uint64_t seed = 1;
  std::uint64_t vectors = 1000000;
};
settings& current_settings();
inline std::uint64_t seed() { return current_settings().seed; }
inline std::uint64_t vector_count() { return current_settings().vectors; }
}  // namespace relievo::test
