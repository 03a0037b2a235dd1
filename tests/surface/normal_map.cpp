// normal_map: the streaming builder against golden on every small map, clamped and wrapped; the promised order; maps back to back.
#include "hls/surface/normal_map.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "golden/surface/normal_map.hpp"
#include "tests/support/map_cases.hpp"

namespace relievo::test {
namespace {

constexpr int widest = 512;
using builder_type = hls::normal_map<widest>;

// Rows in the order in which they come out.
std::vector<int> row_order(int height, bool wrap_v) {
  std::vector<int> rows;
  for (int y = wrap_v && height > 1 ? 1 : 0; y < height; ++y) rows.push_back(y);
  if (wrap_v && height > 1) rows.push_back(0);
  return rows;
}

// One map through the builder: texels, then as many flush rows as it promises; every record against golden.
void expect_normals(builder_type& builder, test_map const& map, hls::map_regs const& regs, hls::normal_map_regs const& normal_regs) {
  const auto golden_regs = as_golden<golden::map_regs>(regs);
  const auto golden_normal_regs = as_golden<golden::normal_map_regs>(normal_regs);
  std::vector<int> order;
  for (const int y : row_order(map.height(), regs.wrap_v))
    for (int x = 0; x < map.width(); ++x) order.push_back(y * map.width() + x);
  std::size_t next = 0;
  const int texels = map.width() * map.height(), steps = texels + builder_type::flush_rows(regs) * map.width();
  for (int step = 0; step < steps; ++step) {
    hls::normal_map_out out{};
    const auto texel = hls::from_raw<formats::texel>(step < texels ? map.texel(step % map.width(), step / map.width()) : 0xbeef);
    if (!builder.step(texel, regs, normal_regs, out)) continue;
    ASSERT_LT(next, order.size());
    const int x = order[next] % map.width(), y = order[next] / map.width();
    ++next;
    ASSERT_EQ(raw(out.x), x) << "record " << next;
    ASSERT_EQ(raw(out.y), y) << "record " << next;
    ASSERT_TRUE(equal_words(out, golden::normal_map<golden::rounded>({x, y}, golden_regs, golden_normal_regs, map.golden_texels())))
        << describe(out) << describe(normal_regs);
    ASSERT_FALSE(out.zero);
  }
  ASSERT_EQ(next, order.size()) << "records missing";
}

hls::normal_map_regs some_regs(generator& g) {
  hls::normal_map_regs regs{};
  draw_vector(regs, static_cast<draw>(g.below(4)), g);
  return regs;
}

TEST(normal_map, hls_equals_golden_map_after_map) {
  const auto builder = std::make_unique<builder_type>();
  generator g("regs");
  for_maps([&](test_map const& map, hls::map_regs const& regs) {
    for (int i = 0; i < 20 && !HasFailure(); ++i) expect_normals(*builder, map, regs, some_regs(g));
  });
}

TEST(normal_map, every_size_up_to_five_in_every_mode_back_to_back) {
  const auto builder = std::make_unique<builder_type>();
  generator g("small");
  for (int round = 0; round < 20; ++round)
    for (int height = 1; height <= 5; ++height)
      for (int width = 1; width <= 5; ++width)
        for (int mode = 0; mode < 4; ++mode) {
          const test_map map(width, height, fill::random, g);
          expect_normals(*builder, map, map.regs(mode % 2 != 0, mode / 2 != 0), some_regs(g));
          if (HasFatalFailure()) FAIL() << width << " x " << height << ", mode " << mode;
        }
}

TEST(normal_map, random_maps_a_million_texels_in_all) {
  const auto builder = std::make_unique<builder_type>();
  generator g("texels");
  for (std::uint64_t texels = 0; texels < vector_count() && !HasFailure();) {
    const int width = static_cast<int>(g.between(1, widest)), height = static_cast<int>(g.between(1, 40));
    const test_map map(width, height, g.chance(2) ? fill::random : fill::random_bits, g);
    // Slopes within the format: the largest difference of two texels at most fills the direction.
    hls::normal_map_regs regs = some_regs(g);
    regs.gradient_u = hls::from_raw<formats::gradient>(raw(regs.gradient_u) >> 12);
    regs.gradient_v = hls::from_raw<formats::gradient>(raw(regs.gradient_v) >> 12);
    expect_normals(*builder, map, map.regs(g.chance(2), g.chance(2)), regs);
    texels += static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  }
}

// Golden's differences against the rule, written out: one-sided and doubled at a clamped border, around the seam where it wraps.
TEST(normal_map, slopes_of_a_row_by_hand) {
  const std::vector<std::uint16_t> row = {100, 130, 190, 110};
  const auto texels = [&](int x, int) { return static_cast<double>(row[static_cast<std::size_t>(x)]); };
  const golden::normal_map_regs regs{1.0 / 256, 0, 0};
  const double clamped[] = {60, 90, -20, -160}, wrapped[] = {20, 90, -20, -90};
  for (int x = 0; x < 4; ++x)
    for (const bool wrap : {false, true}) {
      const double slope = (wrap ? wrapped[x] : clamped[x]) / 256;
      const auto n = golden::normal_map<golden::exact>({x, 0}, {4, 1, wrap, false}, regs, texels).n;
      EXPECT_NEAR(n.x, -slope / std::sqrt(1 + slope * slope), 1e-12) << x << ", wrap " << wrap;
      EXPECT_EQ(n.y, 0);
    }
}

TEST(normal_map, a_slope_beyond_the_direction_is_flagged) {
  const auto builder = std::make_unique<builder_type>();
  generator g("steep");
  const test_map map(8, 8, fill::checker, g);
  hls::normal_map_regs regs{};
  regs.gradient_u = hls::from_raw<formats::gradient>(hls::fixed<formats::gradient>::max_raw);
  bool flagged = false;
  for (int step = 0; step < 8 * 9; ++step) {
    hls::normal_map_out out{};
    const auto texel = hls::from_raw<formats::texel>(step < 64 ? map.texel(step % 8, step / 8) : 0);
    if (builder->step(texel, map.regs(false, false), regs, out)) flagged |= out.saturated;
  }
  EXPECT_TRUE(flagged) << "the clamped border of a checker is as steep as a map can be";
}

}  // namespace
}  // namespace relievo::test
