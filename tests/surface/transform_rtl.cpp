// verilate: Vtransform
// verilate: Vtransform_3 Clocks=3
// transform: the circuit equals the kernel, one vector a clock, 32 clocks later, or one in three clocks and 35 later: on any words, where
// the division is at work, and at the eye.
#include "Vtransform.h"
#include "Vtransform_3.h"
#include "hls/surface/transform.hpp"
#include "tests/support/pipeline.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::transform_in, hls::transform_regs>;

template <class Shape>
void equals_kernel(Shape shape) {
  pipeline_test<Vtransform, vector>(32, shape, [](vector const& v) { return hls::transform(v.in, v.regs); });
}

// A camera before the scene: w between 1 and 127, few saturations.
void before_the_eye(vector& v, generator& g) {
  for (auto& m : v.regs.row_w) m = hls::from_raw<formats::matrix_w>(raw(m) >> 3);
  for (auto& m : v.regs.row_x) m = hls::from_raw<formats::matrix_xy>(raw(m) >> 2);
  for (auto& m : v.regs.row_y) m = hls::from_raw<formats::matrix_xy>(raw(m) >> 2);
  v.regs.offset_x = hls::from_raw<formats::offset_xy>(raw(v.regs.offset_x) >> 5);
  v.regs.offset_y = hls::from_raw<formats::offset_xy>(raw(v.regs.offset_y) >> 5);
  v.regs.offset_w = hls::from_raw<formats::offset_w>(g.between(std::int64_t(8) << 44, std::int64_t(120) << 44));
  v.regs.w_min = hls::from_raw<formats::depth>(std::int64_t(1) << 12);
}

TEST(transform, rtl_equals_hls) { equals_kernel(any_word()); }
TEST(transform, rtl_equals_hls_before_the_eye) { equals_kernel(before_the_eye); }

// |w - w_min| of a few LSB, and w_min = 0 often: w moves with the position, by less than its LSB up to a few.
template <class Model, int Interval>
void equals_kernel_at_the_eye(int latency) {
  std::uint64_t behind = 0, seen = 0;
  pipeline_test<Model, vector, Interval>(
      latency,
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

TEST(transform, rtl_equals_hls_at_the_eye) { equals_kernel_at_the_eye<Vtransform, 1>(32); }

TEST(transform, rtl_equals_hls_in_three_clocks) {
  const auto kernel = [](vector const& v) { return hls::transform(v.in, v.regs); };
  pipeline_test<Vtransform_3, vector, 3>(35, any_word(), kernel);
  pipeline_test<Vtransform_3, vector, 3>(35, before_the_eye, kernel);
  equals_kernel_at_the_eye<Vtransform_3, 3>(35);
}

}  // namespace
}  // namespace relievo::test
