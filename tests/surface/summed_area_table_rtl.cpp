// verilate: Vsummed_area_table
// verilate: Vsummed_area_table_16 MaxWidth=16
//
// summed_area_table: the circuit's words are the kernel's, in order and each with its place, for every small map, a large one, the widest
// one, maps behind each other, and sums beyond 2^40; one texel a clock.
#include "Vsummed_area_table.h"
#include "Vsummed_area_table_16.h"
#include "hls/surface/summed_area_table.hpp"
#include "tests/support/map_builder.hpp"
#include "tests/support/map_cases.hpp"

namespace relievo::test {
namespace {

constexpr std::uint64_t latency = 7;

struct table_write {
  hls::fixed<formats::map_size> x, y;
  hls::fixed<formats::table_sum> sum;
  RELIEVO_FIELDS(x, y, sum)
};

// The kernel, map after map.
class kernel {
 public:
  std::vector<table_write> table(test_map const& map) {
    std::vector<table_write> words;
    words.reserve(map.words().size());
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x)
        words.push_back({hls::from_raw<formats::map_size>(x), hls::from_raw<formats::map_size>(y),
                         builder_->step(hls::from_raw<formats::texel>(map.texel(x, y)), map.regs(false, false))});
    return words;
  }

 private:
  std::unique_ptr<hls::summed_area_table<>> builder_ = std::make_unique<hls::summed_area_table<>>();
};

template <class Bench>
void expect_map(Bench& bench, kernel& hls, traffic const& t, test_map const& map, bool wrap_u, bool wrap_v) {
  const std::uint64_t clocks = bench.build(map.regs(wrap_u, wrap_v), map.words(), hls.table(map));
  if (testing::Test::HasFailure()) FAIL() << map.width() << " x " << map.height();
  if (t.idle == 0 && t.stall == 0) {
    ASSERT_EQ(clocks, map.words().size() + latency) << map.width() << " x " << map.height();
  }
}

TEST(summed_area_table, rtl_equals_hls_map_after_map) {
  for (traffic const& t : builder_traffic()) {
    builder_bench<Vsummed_area_table, table_write> bench(t);
    kernel hls;
    for_maps([&](test_map const& map, hls::map_regs const& regs) { expect_map(bench, hls, t, map, regs.wrap_u, regs.wrap_v); });
    bench.rest();
  }
}

TEST(summed_area_table, rtl_equals_hls_on_every_size_up_to_six) {
  for (traffic const& t : builder_traffic()) {
    builder_bench<Vsummed_area_table_16, table_write> bench(t);
    kernel hls;
    generator g("sizes");
    for (int round = 0; round < 4; ++round)
      for (int height = 1; height <= 6; ++height)
        for (int width = 1; width <= 6; ++width) {
          expect_map(bench, hls, t, test_map(width, height, g.chance(4) ? fill::maximum : fill::random, g), false, false);
          if (HasFailure()) return;
        }
    bench.rest();
  }
}

TEST(summed_area_table, rtl_equals_hls_on_large_maps) {
  for (traffic const& t : builder_traffic()) {
    builder_bench<Vsummed_area_table, table_write> bench(t);
    kernel hls;
    generator g("large");
    for (std::uint64_t texels = 0; texels < rtl_vector_count() && !HasFailure();) {
      const int width = static_cast<int>(g.between(1, 600)), height = static_cast<int>(g.between(1, 200));
      expect_map(bench, hls, t, test_map(width, height, g.chance(4) ? fill::maximum : fill::random, g), false, false);
      texels += static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    }
    for (const auto size : {map_size{16, 16}, map_size{8192, 3}})
      expect_map(bench, hls, t, test_map(size.width, size.height, fill::random, g), false, false);
    // The largest sum of a column.
    expect_map(bench, hls, t, test_map(1, 8192, fill::maximum, g), false, false);
    bench.rest();
  }
}

// Without a pause, the next map's first texel one clock behind the last of the one before.
TEST(summed_area_table, maps_follow_each_other_every_clock) {
  generator g("pairs");
  for (const auto size : map_sizes) {
    builder_bench<Vsummed_area_table, table_write> bench(builder_traffic().front());
    kernel hls;
    std::vector<std::uint16_t> texels;
    std::vector<table_write> expected;
    test_map const* some = nullptr;
    std::vector<test_map> maps;
    for (int i = 0; i < 5; ++i) maps.emplace_back(size.width, size.height, fill::random, g);
    for (test_map const& map : maps) {
      some = &map;
      texels.insert(texels.end(), map.words().begin(), map.words().end());
      const auto words = hls.table(map);
      expected.insert(expected.end(), words.begin(), words.end());
    }
    ASSERT_EQ(bench.build(some->regs(false, false), texels, expected), texels.size() + latency) << size.width << " x " << size.height;
    bench.rest();
  }
}

TEST(summed_area_table, a_reset_ends_a_map) {
  generator g("reset");
  builder_bench<Vsummed_area_table, table_write> bench(builder_traffic().back());
  const test_map before(5, 4, fill::random, g), after(7, 3, fill::random, g);
  for (int clocks = 0; clocks < 40; ++clocks) {
    bench.interrupt(before.regs(false, false), before.words(), clocks);
    kernel hls;
    expect_map(bench, hls, builder_traffic().back(), after, false, false);
    if (HasFailure()) FAIL() << "a reset after " << clocks << " clocks";
  }
  bench.rest();
}

// 65535 in every texel of a map 8192 wide goes beyond 2^40 in its row 2048.
TEST(summed_area_table, rtl_wraps_at_2_to_the_40) {
  auto const& none = builder_traffic().front();
  const auto bench = std::make_unique<builder_bench<Vsummed_area_table, table_write>>(none);
  auto& model = bench->model;
  tb::put(model.map_i, hls::map_regs{hls::from_raw<formats::map_size>(8192), hls::from_raw<formats::map_size>(8192), false, false});
  model.in_valid_i = 1;
  model.in_i = 65535;
  model.out_ready_i = 1;
  std::uint64_t received = 0, wrapped = 0;
  constexpr std::uint64_t mask = (std::uint64_t(1) << 40) - 1, count = 8192 * 2056;
  for (std::uint64_t clock = 0; clock < count + latency; ++clock) {
    model.clk_i = 1;
    model.eval();
    model.clk_i = 0;
    model.eval();
    if (!model.out_valid_o) continue;
    const std::uint64_t x = received % 8192, y = received / 8192, sum = 65535 * (x + 1) * (y + 1);
    ++received;
    // Only where it matters, and some.
    if (y < 2047 && received % 1021 != 0) continue;
    wrapped += sum > mask ? 1 : 0;
    const auto word = tb::get<table_write>(model.out_o);
    ASSERT_EQ(static_cast<std::uint64_t>(raw(word.sum)), sum & mask) << x << ", " << y;
    ASSERT_EQ(static_cast<std::uint64_t>(raw(word.x)), x);
    ASSERT_EQ(static_cast<std::uint64_t>(raw(word.y)), y);
  }
  EXPECT_GT(received, count - 10);
  EXPECT_GT(wrapped, 100u);
}

}  // namespace
}  // namespace relievo::test
