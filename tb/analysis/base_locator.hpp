// base_locator: the base triangle that holds a point of the map, for meshes whose faces don't name theirs.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "golden/edge/triangle.hpp"

namespace relievo::tb {

class base_locator {
 public:
  enum class answer { one, nowhere, several };

  // `base` must outlive the locator; only U is looked at.
  explicit base_locator(std::vector<golden::triangle> const& base);

  // The base triangle that holds u inside; `several` where charts lie over each other in the map.
  answer find(glm::dvec2 const& u, std::uint32_t& index) const;

 private:
  std::size_t cell(double offset, double step) const;
  bool holds(std::uint32_t index, glm::dvec2 const& u) const;

  std::vector<golden::triangle> const& base_;
  glm::dvec2 low_{0.0}, step_{1.0};
  std::size_t side_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace relievo::tb
