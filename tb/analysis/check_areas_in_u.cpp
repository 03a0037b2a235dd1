// check_areas_in_u: flips, missing and excess area of a mesh whose weights aren't known; the bounds are derived in check_words.hpp.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "tb/analysis/check_words.hpp"

namespace relievo::tb {
namespace {

double cross(glm::dvec2 const& a, glm::dvec2 const& b) { return a.x * b.y - a.y * b.x; }
double size1(glm::dvec2 const& a) { return std::abs(a.x) + std::abs(a.y); }

double twice_area(golden::triangle const& t) { return cross(t.v[1].u - t.v[0].u, t.v[2].u - t.v[0].u); }

struct patch {
  double sum = 0.0;  // twice the area
  std::size_t children = 0;
};

class area_checker {
 public:
  area_checker(words_mesh const& m, std::vector<golden::triangle> const& base, check_options const& options, check_report& report)
      : m_(m), base_(base), options_(options), report_(report), d_(rounding_lsbs * m.coordinate_lsb) {}

  void run() {
    std::size_t count = base_.size();
    if (base_.empty()) {
      for (const std::uint32_t b : m_.base_triangle) count = std::max(count, std::size_t{b} + 1);
      if (count > 16 * (m_.triangles.size() + 1)) {
        report_.with_areas = false;  // nobody's numbers of base triangles
        return;
      }
    }
    add_up(count);
    for (std::size_t i = 0; i < m_.triangles.size(); ++i) {
      if (m_.base_triangle[i] < count) orientation(i);
    }
    for (std::size_t b = 0; b < base_.size(); ++b) coverage(b);
  }

 private:
  glm::dvec2 const& corner(std::size_t triangle, std::size_t k) const { return m_.vertices[m_.triangles[triangle][k]].u; }
  double area_of(std::size_t i) const { return cross(corner(i, 1) - corner(i, 0), corner(i, 2) - corner(i, 0)); }

  void add_up(std::size_t count) {
    patches_.assign(count, {});
    for (std::size_t i = 0; i < m_.triangles.size(); ++i) {
      if (m_.base_triangle[i] >= count) {
        ++report_.outside;
        report_.found("outside", "triangle " + std::to_string(i) + " belongs to none of the " + std::to_string(count) + " base triangles");
        continue;
      }
      patches_[m_.base_triangle[i]].sum += area_of(i);
      ++patches_[m_.base_triangle[i]].children;
    }
  }

  // Without a base mesh, the sum of all children says which way round a base triangle is.
  void orientation(std::size_t i) {
    const std::size_t b = m_.base_triangle[i];
    const double whole = base_.empty() ? patches_[b].sum : twice_area(base_[b]);
    const double area = area_of(i);
    const double bound = 2.0 * d_ * (size1(corner(i, 1) - corner(i, 0)) + size1(corner(i, 2) - corner(i, 0))) + 8.0 * d_ * d_;
    if (!((whole > 0.0 && area < -bound) || (whole < 0.0 && area > bound))) return;
    ++report_.flips;
    std::ostringstream where;
    where << "triangle " << i << " at U (" << corner(i, 0).x << ", " << corner(i, 0).y << ")";
    report_.found("flip", where.str());
  }

  void coverage(std::size_t b) {
    auto const& v = base_[b].v;
    const double perimeter = size1(v[1].u - v[0].u) + size1(v[2].u - v[1].u) + size1(v[0].u - v[2].u);
    // No more vertices on the sides than there are children, and the corners.
    const double bound = 2.0 * d_ * perimeter + 2.0 * (static_cast<double>(patches_[b].children) + 2.0) * d_ * d_;
    const double whole = std::abs(twice_area(base_[b]));
    const double sum = twice_area(base_[b]) < 0.0 ? -patches_[b].sum : patches_[b].sum;
    if ((sum < whole - bound || patches_[b].children == 0) && !options_.culled) {
      ++report_.missing_area;
      report_.found("missing area", "base triangle " + std::to_string(b) + " is not covered whole");
    } else if (sum > whole + bound) {
      ++report_.excess_area;
      report_.found("excess area", "base triangle " + std::to_string(b) + " is covered more than once");
    }
  }

  words_mesh const& m_;
  std::vector<golden::triangle> const& base_;
  check_options options_;
  check_report& report_;
  double d_;
  std::vector<patch> patches_;
};

}  // namespace

void check_areas_in_u(words_mesh const& m, std::vector<golden::triangle> const& base, check_options const& options, check_report& report) {
  area_checker(m, base, options, report).run();
}

}  // namespace relievo::tb
