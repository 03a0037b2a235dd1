// summed_area_lookup: against the sum of the texels themselves, and golden; every rectangle on and around small maps, several turns of
// maps of one and two texels, clipped rectangles, tables that have passed 2^40.
#include "hls/surface/summed_area_lookup.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <memory>

#include "golden/surface/summed_area_lookup.hpp"
#include "tests/support/map_cases.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

using input = hls::summed_area_lookup_in;

input rectangle(std::int64_t x0, std::int64_t x1, std::int64_t y0, std::int64_t y1) {
  input in{};
  in.x0 = hls::from_raw<formats::bound>(x0);
  in.x1 = hls::from_raw<formats::bound>(x1);
  in.y0 = hls::from_raw<formats::bound>(y0);
  in.y1 = hls::from_raw<formats::bound>(y1);
  return in;
}

testing::AssertionResult hls_equals_golden(input const& in, hls::map_regs const& regs, hls::table_memory const& memory,
                                           std::function<std::uint64_t(int, int)> const& golden_table) {
  const golden::summed_area_lookup_in at{static_cast<int>(raw(in.x0)), static_cast<int>(raw(in.y0)), static_cast<int>(raw(in.x1)),
                                         static_cast<int>(raw(in.y1))};
  return equal_words(hls::summed_area_lookup(in, regs, memory),
                     golden::summed_area_lookup<golden::rounded>(at, as_golden<golden::map_regs>(regs), golden_table));
}

// The sum of every texel of the rectangle, a wrapped one as often as it comes by, and on a clamped axis the mean of those that
// exist, rounded to 1/16, times the full area. In sixteenths.
std::int64_t definition(input const& in, test_map const& map, hls::map_regs const& regs) {
  std::int64_t sum = 0, inside = 0;
  for (std::int64_t y = raw(in.y0); y < raw(in.y1); ++y)
    for (std::int64_t x = raw(in.x0); x < raw(in.x1); ++x) {
      std::int64_t i = x, j = y;
      if (regs.wrap_u) i = ((x % map.width()) + map.width()) % map.width();
      if (regs.wrap_v) j = ((y % map.height()) + map.height()) % map.height();
      if (i < 0 || i >= map.width() || j < 0 || j >= map.height()) continue;
      sum += map.texel(static_cast<int>(i), static_cast<int>(j));
      ++inside;
    }
  const std::int64_t area = (raw(in.x1) - raw(in.x0)) * (raw(in.y1) - raw(in.y0));
  return inside == area ? sum * 16 : (32 * sum + inside) / (2 * inside) * area;
}

void expect_sum(input const& in, test_map const& map, hls::map_regs const& regs) {
  const std::int64_t right = definition(in, map, regs);
  ASSERT_EQ(raw(hls::summed_area_lookup(in, regs, map.table()).s), right) << describe(in);
  ASSERT_TRUE(hls_equals_golden(in, regs, map.table(), map.golden_table())) << describe(in);
}

// Bounds of an axis of so many texels: all that a summed height test may ask for, and whole turns beyond on a wrapped one.
struct bound_range {
  int low, high;
};
bound_range bounds(int size, bool wrap) { return wrap ? bound_range{-size - 3, 2 * size + 4} : bound_range{-3, size + 3}; }

TEST(summed_area_lookup, every_rectangle_on_and_around_small_maps) {
  generator g("small");
  std::uint64_t looked = 0;
  constexpr map_size sizes[] = {{1, 1}, {2, 2}, {1, 3}, {3, 1}, {2, 3}, {4, 5}};
  for (const map_size size : sizes)
    for (int mode = 0; mode < 4; ++mode) {
      const test_map map(size.width, size.height, fill::random, g);
      const hls::map_regs regs = map.regs(mode % 2 != 0, mode / 2 != 0);
      const bound_range u = bounds(size.width, regs.wrap_u), v = bounds(size.height, regs.wrap_v);
      for (int x0 = u.low; x0 < u.high; ++x0)
        for (int x1 = x0 + 1; x1 <= u.high; ++x1) {
          if (!regs.wrap_u && (x1 <= 0 || x0 >= size.width)) continue;
          for (int y0 = v.low; y0 < v.high; ++y0)
            for (int y1 = y0 + 1; y1 <= v.high; ++y1) {
              if (!regs.wrap_v && (y1 <= 0 || y0 >= size.height)) continue;
              expect_sum(rectangle(x0, x1, y0, y1), map, regs);
              if (HasFatalFailure()) FAIL() << size.width << " x " << size.height << ", mode " << mode;
              ++looked;
            }
        }
    }
  EXPECT_GT(looked, 50000u);
}

// A bound between half a map before and one and a half after on a wrapped axis; some texels beyond on a clamped one, never all.
void place(hls::fixed<formats::bound>& low, hls::fixed<formats::bound>& high, int size, bool wrap, generator& g) {
  const std::int64_t a = wrap ? g.between(-size / 2 - 2, size) : g.between(-std::min(size, 1000), size - 1);
  const std::int64_t b = g.chance(4) ? a + 1 : a + g.between(1, size);
  low = hls::from_raw<formats::bound>(a);
  high = hls::from_raw<formats::bound>(wrap || b > 0 ? b : 1);
}

TEST(summed_area_lookup, hls_equals_golden_on_every_kind_of_map) {
  for_maps([](test_map const& map, hls::map_regs const& regs) {
    std::uint64_t number = 0;
    for_vectors<input>(
        [&](input& in, generator& g) {
          place(in.x0, in.x1, map.width(), regs.wrap_u, g);
          place(in.y0, in.y1, map.height(), regs.wrap_v, g);
        },
        [&](input const& in) {
          if (++number % 16 == 0 && raw(hls::summed_area_lookup(in, regs, map.table()).s) != definition(in, map, regs))
            return testing::AssertionFailure() << "not the sum of the texels, " << definition(in, map, regs) << " / 16";
          return hls_equals_golden(in, regs, map.table(), map.golden_table());
        },
        vector_count() / map_case_count + 1);
  });
}

// A table that began just below 2^40: every difference is unchanged as long as the rectangle stays clear of row and column 0.
TEST(summed_area_lookup, differences_survive_the_wrap_of_the_words) {
  generator g("offset");
  const test_map map(40, 30, fill::maximum, g);
  const hls::map_regs regs = map.regs(false, false);
  const std::uint64_t mask = (std::uint64_t(1) << 40) - 1;
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t offset = mask - g.below(65535u * 40 * 30);
    std::vector<std::uint64_t> words;
    for (int k = 0; k < 40 * 30; ++k) words.push_back((map.table().words[k] + offset) & mask);
    for (int k = 0; k < 50; ++k) {
      const std::int64_t x0 = g.between(1, 38), y0 = g.between(1, 28);
      const input in = rectangle(x0, g.between(x0 + 1, 40), y0, g.between(y0 + 1, 30));
      ASSERT_EQ(raw(hls::summed_area_lookup(in, regs, {words.data()}).s), definition(in, map, regs)) << describe(in);
      ASSERT_TRUE(hls_equals_golden(in, regs, {words.data()}, [&](int x, int y) { return words[static_cast<std::size_t>(y * 40 + x)]; }));
    }
  }
}

// The largest map at its maximum; of its table, zero pages until written, only the words that are read are filled in.
class largest_table {
 public:
  largest_table() : words_(static_cast<std::uint64_t*>(std::calloc(std::size_t(8192) * 8192, sizeof(std::uint64_t))), std::free) {}
  hls::table_memory memory() const { return {words_.get()}; }
  std::uint64_t word(int x, int y) const { return words_.get()[y * 8192 + x]; }
  void fill(int x, int y) {
    if (x >= 0 && x < 8192 && y >= 0 && y < 8192)
      words_.get()[y * 8192 + x] =
          65535 * static_cast<std::uint64_t>(x + 1) * static_cast<std::uint64_t>(y + 1) & ((std::uint64_t(1) << 40) - 1);
  }

 private:
  std::unique_ptr<std::uint64_t, void (*)(void*)> words_;
};

TEST(summed_area_lookup, the_largest_rectangle_of_the_largest_map) {
  largest_table table;
  ASSERT_NE(table.memory().words, nullptr);
  const hls::map_regs clamped = {hls::from_raw<formats::map_size>(8192), hls::from_raw<formats::map_size>(8192), false, false};
  generator g("largest");
  for (int i = 0; i < 300; ++i) {
    const std::int64_t width = i == 0 ? 4096 : g.between(1, 4096), height = i == 0 ? 4096 : g.between(1, 4096);
    const std::int64_t x0 = i == 0 ? 4096 : g.between(-width + 1, 8191), y0 = i == 0 ? 4096 : g.between(-height + 1, 8191);
    const input in = rectangle(x0, x0 + width, y0, y0 + height);
    const std::int64_t left = std::max<std::int64_t>(x0, 0), right = std::min<std::int64_t>(x0 + width, 8192);
    const std::int64_t low = std::max<std::int64_t>(y0, 0), high = std::min<std::int64_t>(y0 + height, 8192);
    for (const std::int64_t x : {left, right})
      for (const std::int64_t y : {low, high}) table.fill(static_cast<int>(x - 1), static_cast<int>(y - 1));
    // A constant map: clipped or not, the sum is 65535 times the full area.
    ASSERT_EQ(raw(hls::summed_area_lookup(in, clamped, table.memory()).s), 65535 * 16 * width * height) << describe(in);
    ASSERT_TRUE(hls_equals_golden(in, clamped, table.memory(), [&](int x, int y) { return table.word(x, y); }));
  }
}

TEST(summed_area_lookup, the_mean_of_a_clipped_rectangle_rounds_half_up) {
  // 32 texels of a clipped column that hold one 1: the mean is half of 1/16.
  std::vector<std::uint16_t> texels(32, 0);
  texels[5] = 1;
  const auto table = golden::summed_area_table(texels.data(), 1, 32);
  const hls::map_regs regs = {hls::from_raw<formats::map_size>(1), hls::from_raw<formats::map_size>(32), false, false};
  EXPECT_EQ(raw(hls::summed_area_lookup(rectangle(-1, 1, 0, 32), regs, {table.data()}).s), 64);
  texels.resize(33);
  const auto longer = golden::summed_area_table(texels.data(), 1, 33);
  const hls::map_regs regs33 = {hls::from_raw<formats::map_size>(1), hls::from_raw<formats::map_size>(33), false, false};
  EXPECT_EQ(raw(hls::summed_area_lookup(rectangle(-1, 1, 0, 33), regs33, {longer.data()}).s), 0);
}

}  // namespace
}  // namespace relievo::test
