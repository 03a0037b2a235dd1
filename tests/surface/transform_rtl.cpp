// transform: the circuit equals the kernel, one vector a clock, 32 clocks later: on any words, where the division is at work, and at the
// eye.
#include "Vtransform.h"
#include "hls/surface/transform.hpp"
#include "tests/support/pipeline.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::transform_in, hls::transform_regs>;

template <class Shape>
void equals_kernel(Shape shape) {
  pipeline_test<Vtransform, vector>(32, shape, [](vector const& v) { return hls::transform(v.in, v.regs); });
}

TEST(transform, rtl_equals_hls) { equals_kernel(any_word()); }

// A camera before the scene: w between 1 and 127, few saturations.
TEST(transform, rtl_equals_hls_before_the_eye) {
  equals_kernel([](vector& v, generator& g) {
    for (auto& m : v.regs.row_w) m = hls::from_raw<formats::matrix_w>(raw(m) >> 3);
    for (auto& m : v.regs.row_x) m = hls::from_raw<formats::matrix_xy>(raw(m) >> 2);
    for (auto& m : v.regs.row_y) m = hls::from_raw<formats::matrix_xy>(raw(m) >> 2);
    v.regs.offset_x = hls::from_raw<formats::offset_xy>(raw(v.regs.offset_x) >> 5);
    v.regs.offset_y = hls::from_raw<formats::offset_xy>(raw(v.regs.offset_y) >> 5);
    v.regs.offset_w = hls::from_raw<formats::offset_w>(g.between(std::int64_t(8) << 44, std::int64_t(120) << 44));
    v.regs.w_min = hls::from_raw<formats::depth>(std::int64_t(1) << 12);
  });
}

// |w - w_min| of a few LSB, and w_min = 0 often: w moves with the position, by less than its LSB up to a few.
TEST(transform, rtl_equals_hls_at_the_eye) {
  std::uint64_t behind = 0, seen = 0;
  pipeline_test<Vtransform, vector>(
      32,
      [](vector& v, generator& g) {
        for (auto& m : v.regs.row_w) m = hls::from_raw<formats::matrix_w>(g.between(-8, 8));
        v.regs.w_min = hls::from_raw<formats::depth>(g.chance(2) ? 0 : g.between(0, 4096));
        v.regs.offset_w =
            hls::from_raw<formats::offset_w>((raw(v.regs.w_min) << 24) + g.between(-(std::int64_t(1) << 24), std::int64_t(1) << 24));
      },
      [&](vector const& v) {
        const auto out = hls::transform(v.in, v.regs);
        ++seen;
        behind += out.behind ? 1 : 0;
        return out;
      });
  EXPECT_GT(behind, seen / 4);
  EXPECT_LT(behind, seen * 3 / 4);
}

}  // namespace
}  // namespace relievo::test
