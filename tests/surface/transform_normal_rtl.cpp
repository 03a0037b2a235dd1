// verilate: Vtransform_normal
// verilate: Vtransform_normal_3 Clocks=3
// transform_normal: the circuit equals the kernel, one vector a clock, six clocks later, or one in three clocks and eight later: on any
// words, and where the eye is close to the plane across the normal, so that `away` hangs on the last bit.
#include "Vtransform_normal.h"
#include "Vtransform_normal_3.h"
#include "hls/surface/transform_normal.hpp"
#include "tests/support/pipeline.hpp"
#include "tests/support/shapes.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::transform_normal_in, hls::transform_normal_regs>;

TEST(transform_normal, rtl_equals_hls) {
  pipeline_test<Vtransform_normal, vector>(6, any_word(), [](vector const& v) { return hls::transform_normal(v.in, v.regs); });
}

// The registers stay in a burst, so it is P' that is laid beside the eye, along (-n.y, n.x, 0), which is perpendicular, and an LSB off.
template <class Model, int Interval>
void equals_kernel_at_grazing_angles(int latency) {
  std::uint64_t away = 0, level = 0, seen = 0;
  pipeline_test<Model, vector, Interval>(
      latency,
      [](vector& v, generator& g) {
        unit_vector(v.in.n, g);
        const std::int64_t step = g.between(-400, 400);
        const std::int64_t off[3] = {-raw(v.in.n[1]) * step, raw(v.in.n[0]) * step, 0};
        for (int i = 0; i < 3; ++i) {
          v.regs.eye[i] = hls::from_raw<formats::eye>(i * 1000);
          std::int64_t p = raw(v.regs.eye[i]) + off[i] + g.between(-1, 1);
          if (p > hls::fixed<formats::position>::max_raw) p = hls::fixed<formats::position>::max_raw;
          if (p < hls::fixed<formats::position>::min_raw) p = hls::fixed<formats::position>::min_raw;
          v.in.p[i] = hls::from_raw<formats::position>(p);
        }
      },
      [&](vector const& v) {
        const auto out = hls::transform_normal(v.in, v.regs);
        std::int64_t facing = 0;
        for (int i = 0; i < 3; ++i) facing += raw(v.in.n[i]) * (raw(v.in.p[i]) - raw(v.regs.eye[i]));
        ++seen;
        away += out.away ? 1 : 0;
        level += facing == 0 ? 1 : 0;
        return out;
      });
  EXPECT_GT(away, seen / 4);
  EXPECT_GT(level, seen / 100) << "no right angles among the vectors";
}

TEST(transform_normal, rtl_equals_hls_at_grazing_angles) { equals_kernel_at_grazing_angles<Vtransform_normal, 1>(6); }

TEST(transform_normal, rtl_equals_hls_in_three_clocks) {
  pipeline_test<Vtransform_normal_3, vector, 3>(8, any_word(), [](vector const& v) { return hls::transform_normal(v.in, v.regs); });
  equals_kernel_at_grazing_angles<Vtransform_normal_3, 3>(8);
}

}  // namespace
}  // namespace relievo::test
