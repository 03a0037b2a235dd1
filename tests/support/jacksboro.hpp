// jacksboro: the scene of the engine's benchmarks and of its clocks: the Jacksboro terrain over 128 base triangles, about 20,000 triangles
// out with the paper's four tests.
#pragma once
#include "tb/host/scene.hpp"

namespace relievo::test {

inline tb::scene_options jacksboro() {
  tb::scene_options options;
  options.mesh = "plane:8";
  options.displacement = RELIEVO_SOURCE_DIR "/tests/data/jacksboro_403x344.png";
  options.sample_range = tb::sample_range{236, 1076};
  options.viewport = {1280, 800};
  options.view_threshold = 1;
  options.normal_threshold = 0.89;
  options.height_threshold = 25000;
  return options;
}

}  // namespace relievo::test
