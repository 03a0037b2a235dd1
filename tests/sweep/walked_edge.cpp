// walked_edge: rows and columns are floor(x + 1/2) of every slope up to 150 steps, and of drawn ones up to 65,535; backward as forward; the
// end is the corner.
#include "hls/sweep/walked_edge.hpp"

#include <gtest/gtest.h>

#include "hls/sweep/walk_data.hpp"
#include "tests/support/random.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using edge = hls::walked_edge<hls::no_data>;

edge edge_of(std::int32_t n, std::int32_t columns, std::int32_t rows, bool rising) {
  return {n, 2 * n, 2 * columns, 2 * rows, 0, 1, 0, rising, {}, {}};
}
std::int64_t nearest(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t n = 2 * numerator + denominator, d = 2 * denominator;
  return n / d - (n % d < 0 ? 1 : 0);
}

testing::AssertionResult steps_right(std::int32_t n, std::int32_t columns, std::int32_t rows) {
  const edge up = edge_of(n, columns, rows, true), down = edge_of(n, -columns, -rows, false);
  hls::edge_place place = hls::detail::edge_begin(up, true, 5, -7);
  hls::edge_place back = hls::detail::edge_begin(down, true, 5 + columns, -7 + rows);
  for (std::int32_t i = 0; i <= n; ++i) {
    const auto fails = [&](char const* what) {
      return testing::AssertionFailure() << what << " at step " << i << " of " << n << " (" << columns << ", " << rows << ")";
    };
    if (place.left != n - i || back.left != n - i) return fails("the steps that are left");
    if (place.column != 5 + nearest(std::int64_t{i} * columns, n)) return fails("the column");
    if (place.row != -7 + nearest(std::int64_t{i} * rows, n)) return fails("the row");
    if (back.column != 5 + nearest(std::int64_t{n - i} * columns, n)) return fails("the column on the way back");
    if (back.row != -7 + nearest(std::int64_t{n - i} * rows, n)) return fails("the row on the way back");
    const auto name = hls::detail::vertex_of(up, place.left), other = hls::detail::vertex_of(down, n - place.left);
    const bool corner = i == 0 || i == n;
    if (raw(name.kind) != (corner ? hls::corner_vertex : hls::edge_vertex) || raw(name.i) != (corner ? 0 : i)) return fails("the name");
    if (!corner && !same_words(name, other)) return fails("the name from the other end");
    if (i == n) break;
    place = hls::detail::edge_step(up, place);
    back = hls::detail::edge_step(down, back);
  }
  return testing::AssertionSuccess();
}

TEST(walked_edge, every_slope_up_to_150_steps) {
  const std::int32_t most = vector_count() < 100000 ? 40 : 150;
  for (std::int32_t n = 1; n <= most; ++n)
    for (std::int32_t d = -n; d <= n; ++d) ASSERT_TRUE(steps_right(n, d, n - std::abs(d)));
}

TEST(walked_edge, drawn_slopes) {
  generator g = next_generator();
  for (std::uint64_t round = 0; round < vector_count() / 20000; ++round) {
    const auto n = static_cast<std::int32_t>(g.between(1, 65534));
    ASSERT_TRUE(steps_right(n, static_cast<std::int32_t>(g.between(-n, n)), static_cast<std::int32_t>(g.between(-n, n))));
  }
}

}  // namespace
}  // namespace relievo::test
