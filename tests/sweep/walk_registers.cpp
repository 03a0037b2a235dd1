// walk_registers: any sequence of puts and assignments leaves every other role with what it had, in twelve registers.
#include "hls/sweep/walk_registers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

// What a role stands for, by value: no register anywhere.
using roles = std::array<std::optional<int>, hls::walk_roles>;

TEST(walk_registers, a_put_leaves_what_other_roles_name) {
  generator g = next_generator();
  const auto role = [&g] { return static_cast<hls::walk_role>(g.below(hls::walk_roles)); };
  hls::walk_registers<int> registers;
  roles right{};
  for (std::uint64_t round = 0; round < vector_count() / 10; ++round) {
    const hls::walk_role to = role(), from = role();
    const int value = static_cast<int>(g.below(1 << 16));
    if (g.chance(8)) {
      registers.invalidate(to);
      right[to].reset();
    } else if (g.chance(2)) {
      registers.assign(to, from);
      right[to] = right[from];
    } else {
      hls::remeshed_vertex name{};
      name.i = hls::from_raw<formats::steps>(value);
      registers.put(to, name, value);
      right[to] = value;
    }
    for (int i = 0; i < hls::walk_roles; ++i) {
      const auto each = static_cast<hls::walk_role>(i);
      if (!right[each]) {
        ASSERT_EQ(registers.index(each), hls::no_vertex);
        continue;
      }
      ASSERT_LT(registers.index(each), hls::walk_registers_count);
      ASSERT_EQ(registers.at(each).data, *right[each]) << "role " << i << ", round " << round;
      ASSERT_EQ(raw(registers[each].i), *right[each]) << "role " << i << ", round " << round;
    }
  }
}

}  // namespace
}  // namespace relievo::test
