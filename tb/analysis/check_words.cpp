#include "tb/analysis/check_words.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <tuple>

#include "tb/analysis/base_sides.hpp"
#include "tb/analysis/open_edges.hpp"
#include "tb/host/value_index.hpp"

namespace relievo::tb {
namespace {

class words_checker {
 public:
  words_checker(words_mesh const& m, std::vector<golden::triangle> const& base, check_options const& options, check_report& report)
      : m_(m), base_(base), options_(options), report_(report), sides_(base, m.map) {
    // Without a base triangle per face nothing can be said of sides.
    located_ = !base.empty() && m.base_triangle.size() == m.triangles.size() && (m.has_p || m.has_u);
  }

  void run() {
    report_.triangles += m_.triangles.size();
    report_.with_base = located_;
    report_.with_areas = m_.has_u && m_.base_triangle.size() == m_.triangles.size();
    identify();
    edges();
    decide();
    if (!options_.culled) t_vertices();
    if (report_.with_areas) check_areas_in_u(m_, base_, options_, report_);
  }

 private:
  struct use {
    std::uint32_t low, high;  // identities
    std::uint32_t corner;     // 3 * triangle + edge; the edge runs on to the next corner
    bool along;               // from low to high
    bool operator<(use const& o) const { return std::tie(low, high, corner) < std::tie(o.low, o.high, o.corner); }
  };

  std::uint32_t from(use const& e) const { return m_.triangles[e.corner / 3][e.corner % 3]; }
  std::uint32_t to(use const& e) const { return m_.triangles[e.corner / 3][(e.corner + 1) % 3]; }

  std::string at(std::uint32_t vertex) const {
    auto const& v = m_.vertices[vertex];
    std::ostringstream text;
    if (m_.has_u) text << "U (" << v.u.x << ", " << v.u.y << ") ";
    glm::dvec3 const& p = m_.has_p ? v.p : v.displaced_p;
    text << (m_.has_p ? "P (" : "P' (") << p.x << ", " << p.y << ", " << p.z << ")";
    return text.str();
  }
  std::string edge_at(use const& e) const {
    return "triangle " + std::to_string(e.corner / 3) + ", edge from " + at(from(e)) + " to " + at(to(e));
  }

  void identify() {
    identity_.reserve(m_.vertices.size());
    value_index<8> index(m_.vertices.size());
    for (auto const& v : m_.vertices) {
      if (!m_.has_p) {
        identity_.push_back(index({v.displaced_p.x, v.displaced_p.y, v.displaced_p.z, 0, 0, 0, 0, 0}));
        continue;
      }
      const glm::dvec2 u = m_.has_u ? unwrapped(v.u, m_.map) : glm::dvec2(0.0);
      const glm::dvec3 t = m_.has_t ? v.t : glm::dvec3(0.0);
      identity_.push_back(index({v.p.x, v.p.y, v.p.z, t.x, t.y, t.z, u.x, u.y}));
    }
  }

  void edges() {
    std::vector<use> uses;
    uses.reserve(3 * m_.triangles.size());
    for (std::size_t i = 0; i < m_.triangles.size(); ++i) {
      std::uint32_t id[3];
      for (std::size_t k = 0; k < 3; ++k) id[k] = identity_[m_.triangles[i][k]];
      if (id[0] == id[1] || id[1] == id[2] || id[2] == id[0]) {
        ++report_.collapsed;
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const auto ends = std::minmax(id[k], id[(k + 1) % 3]);
        uses.push_back({ends.first, ends.second, static_cast<std::uint32_t>(3 * i + k), id[k] < id[(k + 1) % 3]});
      }
    }
    std::sort(uses.begin(), uses.end());
    for (std::size_t i = 0; i < uses.size();) {
      std::size_t j = i;
      while (j < uses.size() && uses[j].low == uses[i].low && uses[j].high == uses[i].high) ++j;
      if (j - i == 1) {
        used_once(uses[i]);
      } else if (j - i == 2 && uses[i].along != uses[i + 1].along) {
        shared(uses[i], uses[i + 1]);
      } else {
        ++report_.overused_edges;
        report_.found("overused edge", edge_at(uses[i]) + ", " + std::to_string(j - i) + " uses");
      }
      i = j;
    }
  }

  void used_once(use const& e) {
    switch (kind_of(e).value_or(side_kind::shared)) {
      case side_kind::boundary:
        ++report_.boundary_edges;
        return;
      case side_kind::border:
        ++report_.border_edges;
        return;
      case side_kind::shared:
        break;
    }
    open_.push_back({from(e), to(e)});
    if (options_.culled) return;
    if (!located_) {
      undecided_.push_back(e);
      return;
    }
    ++report_.open_edges;
    report_.found("open edge", edge_at(e));
  }

  void shared(use const& a, use const& b) {
    if (m_.has_p) {
      if (agree(from(a), to(b)) && agree(to(a), from(b))) {
        ++report_.shared_edges;
        return;
      }
      if (kind_of(a) == side_kind::border) {  // N differs, which the records don't hold
        report_.border_edges += 2;
        return;
      }
      ++report_.parted;
      report_.found("parted", edge_at(a) + ", shared with triangle " + std::to_string(b.corner / 3));
      return;
    }
    if (m_.has_u && !(one_coordinate(from(a), to(b)) && one_coordinate(to(a), from(b)))) {
      report_.border_edges += 2;
      return;
    }
    ++report_.shared_edges;
  }

  // Without a base mesh: two edges of the same undisplaced positions that aren't one edge lie at a border.
  void decide() {
    if (!m_.has_p) {
      report_.undecided_edges += undecided_.size();
      return;
    }
    value_index<3> points(undecided_.size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    const auto point = [&](std::uint32_t vertex) {
      glm::dvec3 const& p = m_.vertices[vertex].p;
      return points({p.x, p.y, p.z});
    };
    for (use const& e : undecided_) ends.push_back(std::minmax({point(from(e)), point(to(e))}));
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i < ends.size();) {
      std::size_t j = i;
      while (j < ends.size() && ends[j] == ends[i]) ++j;
      (j - i > 1 || ends[i].first == ends[i].second ? report_.border_edges : report_.undecided_edges) += j - i;
      i = j;
    }
  }

  bool agree(std::uint32_t a, std::uint32_t b) const {
    auto const& x = m_.vertices[a];
    auto const& y = m_.vertices[b];
    return x.displaced_p == y.displaced_p && (!m_.has_n || x.displaced_n == y.displaced_n);
  }
  bool one_coordinate(std::uint32_t a, std::uint32_t b) const {
    return unwrapped(m_.vertices[a].u, m_.map) == unwrapped(m_.vertices[b].u, m_.map);
  }

  // What lies at the side of its base triangle that an edge lies on; nothing for an edge inside. Where rounding leaves a short edge on
  // two sides, the more lenient one.
  std::optional<side_kind> kind_of(use const& e) const {
    if (!located_) return std::nullopt;
    const std::uint32_t b = m_.base_triangle[e.corner / 3];
    if (b >= base_.size()) return std::nullopt;
    std::optional<side_kind> kind;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!on_side(from(e), b, k) || !on_side(to(e), b, k)) continue;
      const side_kind here = sides_.kind(b, k);
      if (!kind || here == side_kind::border || *kind == side_kind::shared) kind = here;
    }
    return kind;
  }

  bool on_side(std::uint32_t vertex, std::size_t b, std::size_t k) const {
    auto const& v = m_.vertices[vertex];
    golden::vertex const& p = base_[b].v[k];
    golden::vertex const& q = base_[b].v[(k + 1) % 3];
    if (m_.has_p && distance_to_segment(v.p, p.p, q.p) > rounding_lsbs * m_.position_lsb * std::sqrt(3.0)) return false;
    const auto flat = [](glm::dvec2 const& u) { return glm::dvec3(u, 0.0); };
    return !m_.has_u || distance_to_segment(flat(v.u), flat(p.u), flat(q.u)) <= rounding_lsbs * m_.coordinate_lsb * std::sqrt(2.0);
  }

  void t_vertices() {
    std::vector<open_vertex> vertices(m_.vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      auto const& v = m_.vertices[i];
      vertices[i] = {m_.has_p ? v.p : v.displaced_p, v.u, identity_[i], v.t};
    }
    open_tolerance tolerance;
    tolerance.position = rounding_lsbs * m_.position_lsb * std::sqrt(3.0);
    // Vertices of a border have other coordinates than the edge beside them.
    tolerance.use_u = m_.has_u;
    tolerance.use_t = m_.has_t;
    tolerance.coordinate = rounding_lsbs * m_.coordinate_lsb * std::sqrt(2.0);
    tolerance.turn = {m_.map.wrap_u ? m_.map.width : 0.0, m_.map.wrap_v ? m_.map.height : 0.0};
    for (const std::uint32_t vertex : vertices_inside_open_edges(vertices, open_, tolerance)) {
      ++report_.t_vertices;
      report_.found("T-vertex", at(vertex));
    }
  }

  words_mesh const& m_;
  std::vector<golden::triangle> const& base_;
  check_options options_;
  check_report& report_;
  base_sides sides_;
  bool located_ = false;
  std::vector<std::uint32_t> identity_;
  std::vector<std::array<std::uint32_t, 2>> open_;
  std::vector<use> undecided_;
};

}  // namespace

void check_words(words_mesh const& m, std::vector<golden::triangle> const& base, check_options const& options, check_report& report) {
  words_checker(m, base, options, report).run();
}

words_mesh words_of(std::vector<golden::triangle_out> const& out, golden::map_regs const& map) {
  words_mesh m;
  m.map = map;
  m.has_p = m.has_t = m.has_u = m.has_n = true;
  m.position_lsb = std::ldexp(1.0, -formats::position::fraction);
  m.coordinate_lsb = std::ldexp(1.0, -formats::coordinate::fraction);
  m.vertices.reserve(3 * out.size());
  for (auto const& t : out) {
    if (t.empty) continue;
    const auto first = static_cast<std::uint32_t>(m.vertices.size());
    for (auto const& v : t.v) m.vertices.push_back({v.p, v.t, v.u, v.displaced_p, v.displaced_n});
    m.triangles.push_back({first, first + 1, first + 2});
    m.base_triangle.push_back(static_cast<std::uint32_t>(t.index));
  }
  return m;
}

}  // namespace relievo::tb
