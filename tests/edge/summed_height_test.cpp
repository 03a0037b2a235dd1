// summed_height_test: hls equals golden on every kind of map, at its threshold too; against the texels; symmetric in the ends; a
// constant height cancels wherever the rectangles lie; where the half extents step.
#include "hls/edge/summed_height_test.hpp"

#include <gtest/gtest.h>

#include "golden/edge/summed_height_test.hpp"
#include "hls/edge/calculate_new_u.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::summed_height_test_in, hls::summed_height_test_regs>;

void set_midpoint(hls::summed_height_test_in& in) {
  const auto middle = hls::calculate_new_u({{in.u1[0], in.u1[1]}, {in.u2[0], in.u2[1]}, hls::from_raw<formats::weight>(8)});
  for (int i = 0; i < 2; ++i) in.u12[i] = middle.u[i];
}

void edge_within(hls::summed_height_test_in& in, hls::map_regs const& map, generator& g) {
  coordinates_within(in.u1, map, g);
  if (g.chance(2))
    for (int i = 0; i < 2; ++i) near(in.u2[i], in.u1[i], 20000, g);
  coordinates_within(in.u2, map, g);
  set_midpoint(in);
}

testing::AssertionResult agrees(vector const& v, test_map const& map, hls::map_regs const& regs) {
  const auto out = hls::summed_height_test(v.in, regs, v.regs, map.table());
  const auto result = equal_words(
      out, golden::summed_height_test<golden::rounded>(as_golden<golden::summed_height_test_in>(v.in), as_golden<golden::map_regs>(regs),
                                                       as_golden<golden::summed_height_test_regs>(v.regs), map.golden_table()));
  if (!result) return result;
  vector back = v;
  for (int i = 0; i < 2; ++i) {
    back.in.u1[i] = v.in.u2[i];
    back.in.u2[i] = v.in.u1[i];
  }
  if (hls::summed_height_test(back.in, regs, v.regs, map.table()).sht != out.sht)
    return testing::AssertionFailure() << "the ends are not alike";
  return result;
}

// Twice the threshold, in sixteenths, against which the measure is held: the threshold that equals it, give or take an LSB.
void threshold_at(vector& v, test_map const& map, hls::map_regs const& regs, generator& g) {
  const auto sides = golden::summed_height_measure<golden::rounded>(as_golden<golden::summed_height_test_in>(v.in),
                                                                    as_golden<golden::map_regs>(regs), {true, 0, 1}, map.golden_table());
  const auto measure = static_cast<std::int64_t>(sides.measure * 16);
  const std::int64_t sum = measure / 2 + g.between(-1, 1),
                     average = measure / static_cast<std::int64_t>(sides.threshold) + g.between(-1, 1);
  v.regs.sum_threshold = hls::from_raw<formats::sum_threshold>(std::max<std::int64_t>(sum, 0));
  v.regs.average_threshold = hls::from_raw<formats::average_threshold>(std::clamp<std::int64_t>(average, 0, (1 << 20) - 1));
}

TEST(summed_height_test, hls_equals_golden_from_either_end) {
  std::uint64_t positive = 0, seen = 0;
  for_maps([&](test_map const& map, hls::map_regs const& regs) {
    for_vectors<vector>(
        [&](vector& v, generator& g) {
          edge_within(v.in, regs, g);
          if (g.chance(2)) threshold_at(v, map, regs, g);
        },
        [&](vector const& v) {
          ++seen;
          positive += hls::summed_height_test(v.in, regs, v.regs, map.table()).sht ? 1 : 0;
          return agrees(v, map, regs);
        },
        vector_count() / map_case_count + 1);
  });
  EXPECT_GT(positive, seen / 10);
  EXPECT_LT(positive, seen * 9 / 10);
}

// The definition, texel by texel: half extents, centre column, sums or clipped means times the full area, in sixteenths.
std::int64_t sum_by_hand(hls::fixed<formats::coordinate> const (&u)[2], std::int64_t times, std::int64_t const (&e)[2], test_map const& map,
                         hls::map_regs const& regs) {
  const std::int64_t cx = raw(u[0]) / 2048 + 1, cy = raw(u[1]) / 2048 + 1, w = map.width(), h = map.height();
  std::int64_t sum = 0, inside = 0;
  for (std::int64_t y = cy - times * e[1]; y < cy + times * e[1]; ++y)
    for (std::int64_t x = cx - times * e[0]; x < cx + times * e[0]; ++x) {
      if ((!regs.wrap_u && (x < 0 || x >= w)) || (!regs.wrap_v && (y < 0 || y >= h))) continue;
      sum += map.texel(static_cast<int>(((x % w) + w) % w), static_cast<int>(((y % h) + h) % h));
      ++inside;
    }
  const std::int64_t area = 4 * times * times * e[0] * e[1];
  return inside == area ? 16 * sum : (32 * sum + inside) / (2 * inside) * area;
}

bool by_hand(vector const& v, test_map const& map, hls::map_regs const& regs) {
  std::int64_t e[2];
  for (int i = 0; i < 2; ++i) {
    const std::int64_t d = std::abs(raw(v.in.u1[i]) - raw(v.in.u2[i])), size = i == 0 ? map.width() : map.height();
    e[i] = std::max<std::int64_t>(1, (d + 4 * 2048) / (8 * 2048));
    if (i == 0 ? regs.wrap_u : regs.wrap_v) e[i] = std::min(e[i], std::max<std::int64_t>(1, size / 4));
  }
  const std::int64_t ends = sum_by_hand(v.in.u1, 1, e, map, regs) + sum_by_hand(v.in.u2, 1, e, map, regs);
  const std::int64_t measure = std::abs(sum_by_hand(v.in.u12, 2, e, map, regs) - 2 * ends);
  return measure > (v.regs.average ? 16 * e[0] * e[1] * raw(v.regs.average_threshold) : 2 * raw(v.regs.sum_threshold));
}

TEST(summed_height_test, equals_the_texels_by_hand) {
  for_maps([&](test_map const& map, hls::map_regs const& regs) {
    for_vectors<vector>(
        [&](vector& v, generator& g) {
          edge_within(v.in, regs, g);
          threshold_at(v, map, regs, g);
        },
        [&](vector const& v) {
          const bool right = by_hand(v, map, regs);
          return hls::summed_height_test(v.in, regs, v.regs, map.table()).sht == right ? testing::AssertionSuccess()
                                                                                       : testing::AssertionFailure() << "by hand " << right;
        },
        vector_count() / map_case_count / 40 + 1);
  });
}

TEST(summed_height_test, a_constant_height_cancels_everywhere) {
  generator g("constant");
  for (const fill how : {fill::constant, fill::maximum})
    for (const map_size size : map_sizes)
      for (int mode = 0; mode < 4; ++mode) {
        const test_map map(size.width, size.height, how, g);
        const hls::map_regs regs = map.regs(mode % 2 != 0, mode / 2 != 0);
        for (int i = 0; i < 400; ++i) {
          vector v{};
          draw_vector(v.in, static_cast<draw>(i % 4), g);
          edge_within(v.in, regs, g);
          v.regs.average = g.chance(2);
          ASSERT_FALSE(hls::summed_height_test(v.in, regs, v.regs, map.table()).sht)
              << size.width << " x " << size.height << ", mode " << mode << "\n"
              << describe(v);
        }
      }
}

TEST(summed_height_test, half_extents_step_at_every_eighth_and_stop_at_a_quarter_of_a_wrapped_axis) {
  for (const std::int64_t size : {1, 2, 3, 4, 7, 8, 64, 8192})
    for (const bool wrap : {false, true})
      for (std::int64_t eighths = 0; eighths <= std::min<std::int64_t>(size, 1100); ++eighths)
        for (const std::int64_t off : {-1, 0, 1}) {
          const std::int64_t d = eighths * 4 * 2048 + off;
          if (d < 0 || d > size * 2048) continue;
          const std::int64_t right = std::max<std::int64_t>(1, (eighths + (off < 0 ? 0 : 1)) / 2);
          const std::int64_t limit = wrap ? std::max<std::int64_t>(1, size / 4) : 1024;
          const auto e = hls::detail::half_extent_of(hls::from_raw<formats::coordinate>(d), hls::from_raw<formats::coordinate>(0),
                                                     hls::from_raw<formats::map_size>(size), wrap);
          ASSERT_EQ(raw(e), std::min(right, limit)) << "d = " << d << " / 2048, size " << size << ", wrap " << wrap;
          const auto golden_e =
              golden::summed_height_extent({0, 0}, {static_cast<double>(d) / 2048, 0}, {static_cast<double>(size), 1, wrap, false});
          ASSERT_EQ(golden_e.x, raw(e));
        }
}

}  // namespace
}  // namespace relievo::test
