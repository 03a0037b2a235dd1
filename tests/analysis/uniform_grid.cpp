// The uniform grid on Jacksboro: figures known from elsewhere (a prototype in double precision, issue 3's table).
#include <gtest/gtest.h>

#include "tb/analysis/error.hpp"
#include "tb/host/map.hpp"

namespace relievo::test {
namespace {

TEST(uniform_grid, jacksboro_in_metres) {
  const tb::displacement_map file = tb::read_map(RELIEVO_SOURCE_DIR "/tests/data/jacksboro_403x344.png", tb::sample_range{236, 1076});
  tb::height_map map;
  map.texels = file.texels.data();
  map.width = file.width;
  map.height = file.height;
  map.scale = 0.3 / 65535;
  map.range_low = 236;
  map.range_high = 1076;
  struct figure {
    std::uint64_t triangles;
    double rms, max;
  };
  for (figure const& f : {figure{6571, 28.2, 155}, figure{23940, 13.6, 81}, figure{57119, 8.0, 46}}) {
    const auto r = tb::uniform_grid_error(map, f.triangles);
    EXPECT_NEAR(static_cast<double>(r.triangles), static_cast<double>(f.triangles), 0.01 * static_cast<double>(f.triangles));
    EXPECT_NEAR(r.error.physical.rms, f.rms, 0.06);
    EXPECT_NEAR(r.error.physical.max, f.max, 0.5);
  }
}

}  // namespace
}  // namespace relievo::test
