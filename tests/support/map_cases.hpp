// map_cases: the maps that every unit with a map memory is tried on: one texel, single rows and columns, two texels, sizes that are no
// powers of two; each clamped and wrapped on either axis.
//
//   for_maps(check)                        check(test_map const&, map_regs const&) for each, filled in turn by all fills
#pragma once
#include "tests/support/maps.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {

struct map_size {
  int width, height;
};
constexpr map_size map_sizes[] = {{1, 1}, {2, 2}, {1, 7}, {9, 1}, {2, 3}, {3, 2}, {5, 4}, {16, 16}, {13, 37}, {100, 61}, {512, 3}};

template <class Check>
void for_maps(Check check) {
  generator g("maps");
  int number = 0;
  for (const map_size size : map_sizes)
    for (int mode = 0; mode < 4; ++mode) {
      const test_map map(size.width, size.height, number % 3 == 2 ? all_fills[number % 7] : fill::random, g);
      ++number;
      check(map, map.regs(mode % 2 != 0, mode / 2 != 0));
      if (testing::Test::HasFailure()) {
        ADD_FAILURE() << size.width << " x " << size.height << " texels, wrap u " << mode % 2 << ", wrap v " << mode / 2;
        return;
      }
    }
}

constexpr std::uint64_t map_case_count = 4 * (sizeof map_sizes / sizeof map_sizes[0]);

}  // namespace relievo::test
