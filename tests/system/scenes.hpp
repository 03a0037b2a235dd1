// scenes: the list that every whole-scene test runs, small enough for the regression. docs of each in its comment.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tb/host/scene.hpp"
#include "tb/model/model.hpp"

namespace relievo::test {

struct named_scene {
  std::string name;
  std::function<tb::scene()> make;
  bool in_range = true;  // nothing may saturate
  bool whole = true;     // check must find nothing
  // What the scene is on the list for, where a counter or a record shows it; empty: the scene itself is the point.
  std::function<bool(tb::run_result const&)> shows = {};
};

std::vector<named_scene> const& all_scenes();

// A scene on meshes and maps that are made here.
tb::mesh single_triangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec2 ua, glm::dvec2 ub, glm::dvec2 uc);
tb::displacement_map rough_map(int width, int height, unsigned seed);

}  // namespace relievo::test
