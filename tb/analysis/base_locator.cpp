#include "tb/analysis/base_locator.hpp"

#include <algorithm>
#include <cmath>

namespace relievo::tb {
namespace {

double cross(glm::dvec2 const& a, glm::dvec2 const& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

base_locator::base_locator(std::vector<golden::triangle> const& base) : base_(base) {
  if (base.empty()) {
    cells_.resize(1);
    return;
  }
  glm::dvec2 high = base.front().v[0].u;
  low_ = high;
  for (auto const& t : base) {
    for (auto const& v : t.v) {
      low_ = glm::min(low_, v.u);
      high = glm::max(high, v.u);
    }
  }
  side_ = std::clamp<std::size_t>(static_cast<std::size_t>(std::sqrt(static_cast<double>(base.size()))), 1, 1024);
  step_ = glm::max((high - low_) / static_cast<double>(side_), glm::dvec2(1e-12));
  cells_.resize(side_ * side_);
  for (std::size_t i = 0; i < base.size(); ++i) {
    auto const& v = base[i].v;
    const glm::dvec2 from = glm::min(v[0].u, glm::min(v[1].u, v[2].u));
    const glm::dvec2 to = glm::max(v[0].u, glm::max(v[1].u, v[2].u));
    for (std::size_t y = cell(from.y - low_.y, step_.y); y <= cell(to.y - low_.y, step_.y); ++y) {
      for (std::size_t x = cell(from.x - low_.x, step_.x); x <= cell(to.x - low_.x, step_.x); ++x) {
        cells_[y * side_ + x].push_back(static_cast<std::uint32_t>(i));
      }
    }
  }
}

std::size_t base_locator::cell(double x, double step) const {
  return std::min(side_ - 1, static_cast<std::size_t>(std::max(0.0, x / step)));
}

bool base_locator::holds(std::uint32_t index, glm::dvec2 const& u) const {
  auto const& v = base_[index].v;
  const double whole = cross(v[1].u - v[0].u, v[2].u - v[0].u);
  if (whole == 0.0) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (cross(v[(k + 1) % 3].u - v[k].u, u - v[k].u) / whole < 0.0) return false;
  }
  return true;
}

base_locator::answer base_locator::find(glm::dvec2 const& u, std::uint32_t& index) const {
  answer result = answer::nowhere;
  for (const std::uint32_t i : cells_[cell(u.y - low_.y, step_.y) * side_ + cell(u.x - low_.x, step_.x)]) {
    if (!holds(i, u)) continue;
    if (result == answer::one) return answer::several;
    result = answer::one;
    index = i;
  }
  return result;
}

}  // namespace relievo::tb
