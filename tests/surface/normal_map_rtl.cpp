// verilate: Vnormal_map
// verilate: Vnormal_map_16 MaxWidth=16
//
// normal_map: the circuit's words are the kernel's, in the kernel's order, for every small map clamped and wrapped on either axis,
// large maps, the widest one, and maps behind each other with other registers; a texel a clock, and a clock a column of a flush row.
#include "Vnormal_map.h"
#include "Vnormal_map_16.h"
#include "hls/surface/normal_map.hpp"
#include "tests/support/map_builder.hpp"
#include "tests/support/map_cases.hpp"

namespace relievo::test {
namespace {

constexpr std::uint64_t latency = 32;

using builder_type = hls::normal_map<>;

// The kernel, map after map.
class kernel {
 public:
  std::vector<hls::normal_map_out> normals(test_map const& map, hls::map_regs const& map_regs, hls::normal_map_regs const& regs) {
    std::vector<hls::normal_map_out> words;
    const int texels = map.width() * map.height(), steps = texels + builder_type::flush_rows(map_regs) * map.width();
    for (int step = 0; step < steps; ++step) {
      hls::normal_map_out out{};
      const auto texel = hls::from_raw<formats::texel>(step < texels ? map.texel(step % map.width(), step / map.width()) : 0);
      if (builder_->step(texel, map_regs, regs, out)) words.push_back(out);
    }
    return words;
  }

 private:
  std::unique_ptr<builder_type> builder_ = std::make_unique<builder_type>();
};

std::uint64_t steps_of(test_map const& map, hls::map_regs const& regs) {
  return static_cast<std::uint64_t>(map.width()) * static_cast<std::uint64_t>(map.height() + builder_type::flush_rows(regs));
}

// Any registers, and, as often, slopes within the direction.
hls::normal_map_regs some_regs(generator& g) {
  hls::normal_map_regs regs{};
  draw_vector(regs, static_cast<draw>(g.below(4)), g);
  if (g.chance(2)) {
    regs.gradient_u = hls::from_raw<formats::gradient>(raw(regs.gradient_u) >> 12);
    regs.gradient_v = hls::from_raw<formats::gradient>(raw(regs.gradient_v) >> 12);
  }
  return regs;
}

template <class Bench>
void expect_map(Bench& bench, kernel& hls, traffic const& t, test_map const& map, hls::map_regs const& map_regs,
                hls::normal_map_regs const& regs) {
  tb::put(bench.model.regs_i, regs);
  const auto words = hls.normals(map, map_regs, regs);
  ASSERT_EQ(words.size(), map.words().size());
  const std::uint64_t clocks = bench.build(map_regs, map.words(), words);
  if (testing::Test::HasFailure())
    FAIL() << map.width() << " x " << map.height() << ", wrap " << map_regs.wrap_u << ", " << map_regs.wrap_v << "\n" << describe(regs);
  if (t.idle == 0 && t.stall == 0) {
    ASSERT_EQ(clocks, steps_of(map, map_regs) + latency) << map.width() << " x " << map.height();
  }
}

TEST(normal_map, rtl_equals_hls_map_after_map) {
  for (traffic const& t : builder_traffic()) {
    builder_bench<Vnormal_map, hls::normal_map_out> bench(t);
    kernel hls;
    generator g("regs");
    for_maps([&](test_map const& map, hls::map_regs const& map_regs) { expect_map(bench, hls, t, map, map_regs, some_regs(g)); });
    bench.rest();
  }
}

TEST(normal_map, rtl_equals_hls_on_every_size_up_to_six_in_every_mode) {
  for (traffic const& t : builder_traffic()) {
    builder_bench<Vnormal_map_16, hls::normal_map_out> bench(t);
    kernel hls;
    generator g("sizes");
    for (int round = 0; round < 4; ++round)
      for (int height = 1; height <= 6; ++height)
        for (int width = 1; width <= 6; ++width)
          for (int mode = 0; mode < 4; ++mode) {
            const test_map map(width, height, fill::random, g);
            expect_map(bench, hls, t, map, map.regs(mode % 2 != 0, mode / 2 != 0), some_regs(g));
            if (HasFailure()) return;
          }
    bench.rest();
  }
}

TEST(normal_map, rtl_equals_hls_on_large_maps) {
  for (traffic const& t : builder_traffic()) {
    builder_bench<Vnormal_map, hls::normal_map_out> bench(t);
    kernel hls;
    generator g("large");
    for (std::uint64_t texels = 0; texels < rtl_vector_count() / 2 && !HasFailure();) {
      const int width = static_cast<int>(g.between(1, 600)), height = static_cast<int>(g.between(1, 100));
      const test_map map(width, height, g.chance(2) ? fill::random : fill::random_bits, g);
      expect_map(bench, hls, t, map, map.regs(g.chance(2), g.chance(2)), some_regs(g));
      texels += static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    }
    for (const auto size : {map_size{16, 16}, map_size{8192, 3}, map_size{1, 8192}}) {
      const test_map map(size.width, size.height, fill::random, g);
      expect_map(bench, hls, t, map, map.regs(true, true), some_regs(g));
    }
    bench.rest();
  }
}

// Without a pause, the next map's first texel one clock behind the last flush row of the one before.
TEST(normal_map, maps_follow_each_other_every_clock) {
  generator g("pairs");
  for (const auto size : map_sizes)
    for (int mode = 0; mode < 4; ++mode) {
      builder_bench<Vnormal_map, hls::normal_map_out> bench(builder_traffic().front());
      kernel hls;
      const hls::normal_map_regs regs = some_regs(g);
      tb::put(bench.model.regs_i, regs);
      std::vector<std::uint16_t> texels;
      std::vector<hls::normal_map_out> expected;
      std::uint64_t steps = 0;
      hls::map_regs map_regs{};
      for (int i = 0; i < 3; ++i) {
        const test_map map(size.width, size.height, fill::random, g);
        map_regs = map.regs(mode % 2 != 0, mode / 2 != 0);
        texels.insert(texels.end(), map.words().begin(), map.words().end());
        const auto words = hls.normals(map, map_regs, regs);
        expected.insert(expected.end(), words.begin(), words.end());
        steps += steps_of(map, map_regs);
      }
      ASSERT_EQ(bench.build(map_regs, texels, expected), steps + latency) << size.width << " x " << size.height << ", mode " << mode;
      bench.rest();
    }
}

TEST(normal_map, a_reset_ends_a_map) {
  generator g("reset");
  traffic const& t = builder_traffic().back();
  builder_bench<Vnormal_map, hls::normal_map_out> bench(t);
  const test_map before(5, 4, fill::random, g), after(7, 3, fill::random, g);
  for (int clocks = 0; clocks < 60; ++clocks) {
    bench.interrupt(before.regs(true, true), before.words(), clocks);
    kernel hls;
    expect_map(bench, hls, t, after, after.regs(clocks % 2 != 0, clocks % 4 < 2), some_regs(g));
    if (HasFailure()) FAIL() << "a reset after " << clocks << " clocks";
  }
  bench.rest();
}

}  // namespace
}  // namespace relievo::test
