// get_triangle: the circuit equals the kernel, a clock later; anywhere and with generations next to the limit.
#include "Vget_triangle.h"
#include "hls/edge/get_triangle.hpp"
#include "tests/support/pipeline.hpp"

namespace relievo::test {
namespace {

struct vector {
  hls::triangle in;
  hls::fixed<formats::generation> max_generation;
  RELIEVO_FIELDS(in, max_generation)
};

TEST(get_triangle, rtl_equals_hls) {
  pipeline_test<Vget_triangle, vector>(
      1,
      [](vector& v, generator& g) {
        for (int i = 0; i < 3; ++i)
          if (g.chance(2)) {
            const std::int64_t near = raw(v.max_generation) + g.between(-1, 1);
            v.in.generation[i] = hls::from_raw<formats::generation>(near < 0 ? 0 : near > 15 ? 15 : near);
          }
      },
      [](vector const& v) { return hls::get_triangle(v.in, v.max_generation); });
}

}  // namespace
}  // namespace relievo::test
