#include "tb/analysis/base_sides.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "tb/analysis/check.hpp"
#include "tb/host/value_index.hpp"

namespace relievo::tb {

base_sides::base_sides(std::vector<golden::triangle> const& base, golden::map_regs const& map)
    : kinds_(3 * base.size(), side_kind::boundary) {
  value_index<11> vertices(3 * base.size());
  value_index<3> points(3 * base.size());
  struct entry {
    std::uint32_t low, high;  // vertices
    std::uint32_t point_low, point_high;
    place where;
  };
  std::vector<entry> sides;
  sides.reserve(3 * base.size());
  for (std::size_t i = 0; i < base.size(); ++i) {
    std::uint32_t vertex[3];
    std::uint32_t point[3];
    for (std::size_t k = 0; k < 3; ++k) {
      golden::vertex const& v = base[i].v[k];
      const glm::dvec2 u = unwrapped(v.u, map);
      vertex[k] = vertices({v.p.x, v.p.y, v.p.z, v.n.x, v.n.y, v.n.z, v.t.x, v.t.y, v.t.z, u.x, u.y});
      point[k] = points({v.p.x, v.p.y, v.p.z});
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const auto ends = std::minmax(vertex[k], vertex[next]);
      const auto at = std::minmax(point[k], point[next]);
      sides.push_back({ends.first,
                       ends.second,
                       at.first,
                       at.second,
                       {static_cast<std::uint32_t>(i), static_cast<std::uint8_t>(k), vertex[k] <= vertex[next]}});
    }
  }

  const auto by_points = [](entry const& a, entry const& b) {
    return std::pair(a.point_low, a.point_high) < std::pair(b.point_low, b.point_high);
  };
  const auto by_vertices = [](entry const& a, entry const& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); };
  const auto for_each_run = [&](auto const& order, auto&& visit) {
    std::stable_sort(sides.begin(), sides.end(), order);
    for (auto first = sides.begin(); first != sides.end();) {
      auto last = first;
      while (last != sides.end() && !order(*first, *last)) ++last;
      visit(first, last);
      first = last;
    }
  };
  const auto mark = [&](entry const& e, side_kind kind) { kinds_[3 * std::size_t{e.where.triangle} + e.where.side] = kind; };

  for_each_run(by_points, [&](auto first, auto last) {
    if (last - first < 2 && first->point_low != first->point_high) return;
    for (auto e = first; e != last; ++e) mark(*e, side_kind::border);
  });
  for_each_run(by_vertices, [&](auto first, auto last) {
    if (last - first < 2) return;
    std::vector<place> group;
    for (auto e = first; e != last; ++e) {
      mark(*e, side_kind::shared);
      group.push_back(e->where);
    }
    groups_.push_back(std::move(group));
  });
}

namespace {

class normals_by_position {
 public:
  void add(glm::dvec3 const& p, glm::dvec3 const& n) {
    const std::uint32_t point = points_({p.x, p.y, p.z});
    if (point == first_normal_.size()) {
      first_normal_.push_back(n);
      return;
    }
    if (first_normal_[point] != n && differing_.insert(point).second && differing_.size() == 1) example_ = p;
  }
  std::vector<std::string> warnings() const {
    if (differing_.empty()) return {};
    std::ostringstream text;
    text << differing_.size() << (differing_.size() == 1 ? " position has" : " positions have")
         << " vertices with different normals; displaced surfaces part there (first: " << example_.x << ", " << example_.y << ", "
         << example_.z << ")";
    return {text.str()};
  }

 private:
  value_index<3> points_;
  std::vector<glm::dvec3> first_normal_;
  std::set<std::uint32_t> differing_;
  glm::dvec3 example_{0.0};
};

}  // namespace

std::vector<std::string> base_warnings(std::vector<golden::triangle> const& base) {
  normals_by_position seen;
  for (auto const& t : base) {
    for (auto const& v : t.v) seen.add(v.p, v.n);
  }
  return seen.warnings();
}

std::vector<std::string> base_warnings(mesh const& base) {
  normals_by_position seen;
  for (auto const& v : base.vertices) seen.add(v.p, v.n);
  return seen.warnings();
}

}  // namespace relievo::tb
