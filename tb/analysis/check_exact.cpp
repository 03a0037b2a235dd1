#include "tb/analysis/check_exact.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <tuple>

#include "tb/analysis/base_sides.hpp"
#include "tb/analysis/exact_weights.hpp"
#include "tb/analysis/progress.hpp"

namespace relievo::tb {
namespace {

using namespace exact_weights;
constexpr std::uint32_t none = 0xffffffffu;

// A piece of a base triangle's side: from parameter t0 to t1, increasing in the side's group direction.
struct piece {
  std::int64_t t0, t1;
  std::uint32_t corner0, corner1;
};

class exact_checker {
 public:
  exact_checker(std::vector<golden::triangle_out> const& out, std::vector<golden::triangle> const& base, golden::map_regs const& map,
                check_options const& options, check_report& report)
      : out_(out), base_(base), map_(map), options_(options), report_(report), sides_(base, map), pieces_(3 * base.size()) {
    forward_.assign(3 * base.size(), true);
    for (auto const& group : sides_.groups()) {
      for (auto const& place : group) forward_[3 * std::size_t{place.triangle} + place.side] = place.forward;
    }
  }

  void run() {
    bin();
    progress bar("checking base triangles", base_.size());
    for (std::size_t b = 0; b < base_.size(); ++b) {
      children_of(b);
      bar.advance();
    }
    for (auto const& group : sides_.groups()) {
      for (std::size_t i = 1; i < group.size(); ++i) compare(group[0], group[i]);
    }
  }

 private:
  // Triangles of b were left out on purpose.
  bool loose(std::size_t b) const { return options_.culled || (b < options_.loose.size() && options_.loose[b]); }

  golden::out_vertex const& vertex(std::uint32_t corner) const { return out_[corner / 3].v[corner % 3]; }

  std::string at(std::uint32_t corner) const {
    auto const& v = vertex(corner);
    std::ostringstream text;
    text << "U (" << v.u.x << ", " << v.u.y << ") P (" << v.p.x << ", " << v.p.y << ", " << v.p.z << ")";
    return text.str();
  }
  std::string edge_at(std::size_t b, std::uint32_t from, std::uint32_t to) const {
    return "base triangle " + std::to_string(b) + ", edge from " + at(from) + " to " + at(to);
  }

  bool same_words(std::uint32_t a, std::uint32_t b) const {
    auto const& x = vertex(a);
    auto const& y = vertex(b);
    return x.p == y.p && x.t == y.t && unwrapped(x.u, map_) == unwrapped(y.u, map_) && x.displaced_p == y.displaced_p &&
           x.displaced_n == y.displaced_n;
  }

  // Triangles by base triangle; those that can't belong to one are counted and left out.
  void bin() {
    first_.assign(base_.size() + 1, 0);
    std::vector<std::uint32_t> home(out_.size(), none);
    for (std::size_t i = 0; i < out_.size(); ++i) {
      if (out_[i].empty) continue;
      ++report_.triangles;
      bool inside = out_[i].index >= 0.0 && out_[i].index < static_cast<double>(base_.size());
      for (auto const& v : out_[i].v) inside = inside && is_inside(v.barycentric);
      if (!inside) {
        ++report_.outside;
        report_.found("outside", "triangle " + std::to_string(i) + " of the output lies in no base triangle");
        continue;
      }
      home[i] = static_cast<std::uint32_t>(out_[i].index);
      ++first_[home[i] + 1];
    }
    for (std::size_t b = 0; b < base_.size(); ++b) first_[b + 1] += first_[b];
    members_.resize(first_.back());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < out_.size(); ++i) {
      if (home[i] != none) members_[fill[home[i]]++] = static_cast<std::uint32_t>(i);
    }
  }

  void children_of(std::size_t b) {
    areas(b);
    weld(b);
    edges(b);
  }

  void areas(std::size_t b) {
    const int128 whole = static_cast<int128>(one) * one;
    int128 sum = 0;
    bool too_much = false;
    for (std::size_t m = first_[b]; m < first_[b + 1]; ++m) {
      auto const& v = out_[members_[m]].v;
      const int128 a = area(v[0].barycentric, v[1].barycentric, v[2].barycentric);
      if (a < 0) {
        ++report_.flips;
        report_.found("flip", edge_at(b, 3 * members_[m], 3 * members_[m] + 1));
      } else if (a == 0) {
        ++report_.degenerate;
        report_.found("degenerate", edge_at(b, 3 * members_[m], 3 * members_[m] + 1));
      }
      // Held within 16 times the whole, so that the sum never leaves 128 bits however broken the mesh is.
      sum = std::max(sum + a, -16 * whole);
      if (sum > 16 * whole) {
        too_much = true;
        sum = 0;
      }
    }
    if (too_much || sum > whole) {
      ++report_.excess_area;
      report_.found("excess area", "base triangle " + std::to_string(b) + " is covered more than once");
    } else if (sum < whole && !loose(b)) {
      ++report_.missing_area;
      report_.found("missing area", "base triangle " + std::to_string(b) + " is not covered whole");
    }
  }

  // Numbers the vertices of base triangle b by their weights; id_ runs parallel to its corners.
  void weld(std::size_t b) {
    const std::size_t count = 3 * (first_[b + 1] - first_[b]);
    order_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t corner = 3 * members_[first_[b] + i / 3] + static_cast<std::uint32_t>(i % 3);
      order_.push_back({vertex(corner).barycentric[0], vertex(corner).barycentric[1], corner, static_cast<std::uint32_t>(i)});
    }
    std::sort(order_.begin(), order_.end());
    id_.resize(count);
    corner_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const bool fresh =
          i == 0 || std::get<0>(order_[i]) != std::get<0>(order_[i - 1]) || std::get<1>(order_[i]) != std::get<1>(order_[i - 1]);
      const std::uint32_t corner = std::get<2>(order_[i]);
      bool differs = false;
      if (fresh) {
        corner_.push_back(corner);
      } else {
        differs = !same_words(corner, corner_.back()) || vertex(corner).u != vertex(corner_.back()).u;
      }
      if (differs) {
        ++report_.parted;
        report_.found("parted", "base triangle " + std::to_string(b) + ", one vertex with two records at " + at(corner));
      }
      id_[std::get<3>(order_[i])] = static_cast<std::uint32_t>(corner_.size() - 1);
    }
  }

  void edges(std::size_t b) {
    uses_.clear();
    for (std::size_t i = 0; i < id_.size(); ++i) {
      const std::uint32_t from = id_[i];
      const std::uint32_t to = id_[i % 3 == 2 ? i - 2 : i + 1];
      if (from == to) continue;  // counted as degenerate
      uses_.push_back({std::min(from, to), std::max(from, to), from < to});
    }
    std::sort(uses_.begin(), uses_.end());
    open_.clear();
    for (std::size_t i = 0; i < uses_.size();) {
      std::size_t j = i;
      std::size_t along = 0;
      while (j < uses_.size() && std::get<0>(uses_[j]) == std::get<0>(uses_[i]) && std::get<1>(uses_[j]) == std::get<1>(uses_[i])) {
        along += std::get<2>(uses_[j]) ? 1u : 0u;
        ++j;
      }
      const std::uint32_t from = corner_[std::get<0>(uses_[i])];
      const std::uint32_t to = corner_[std::get<1>(uses_[i])];
      const std::size_t side = side_of(vertex(from).barycentric, vertex(to).barycentric);
      const std::size_t expected = side == 3 ? 2 : 1;
      if (j - i == 2 && along == 1 && side == 3) {
        ++report_.shared_edges;
      } else if (j - i == 1 && side == 3) {
        open_.push_back({from, to});
        if (!loose(b)) {
          ++report_.open_edges;
          report_.found("open edge", edge_at(b, from, to));
        }
      } else if (j - i > expected || side == 3) {
        ++report_.overused_edges;
        report_.found("overused edge", edge_at(b, from, to));
      }
      if (side != 3) add_piece(b, side, from, to);
      i = j;
    }
    if (!loose(b)) t_vertices_inside(b);
  }

  void add_piece(std::size_t b, std::size_t side, std::uint32_t from, std::uint32_t to) {
    const std::size_t place = 3 * b + side;
    switch (sides_.kind(b, side)) {
      case side_kind::boundary:
        ++report_.boundary_edges;
        return;
      case side_kind::border:
        ++report_.border_edges;
        return;
      case side_kind::shared:
        break;
    }
    const auto parameter = [&](std::uint32_t corner) {
      const std::int64_t t = vertex(corner).barycentric[(side + 1) % 3];
      return forward_[place] ? t : one - t;
    };
    piece p{parameter(from), parameter(to), from, to};
    if (p.t0 > p.t1) p = {p.t1, p.t0, p.corner1, p.corner0};
    pieces_[place].push_back(p);
  }

  void t_vertices_inside(std::size_t b) {
    // A vertex inside an open edge is itself the end of open edges. Past a few thousand the mesh is ruined and the count with it.
    constexpr std::size_t most = 4096;
    std::vector<std::uint32_t> ends;
    for (auto const& e : open_) ends.insert(ends.end(), e.begin(), e.end());
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    if (ends.size() > most) ends.resize(most);
    if (open_.size() > most) open_.resize(most);
    for (const std::uint32_t x : ends) {
      for (auto const& e : open_) {
        if (!strictly_between(vertex(x).barycentric, vertex(e[0]).barycentric, vertex(e[1]).barycentric)) continue;
        ++report_.t_vertices;
        report_.found("T-vertex", "base triangle " + std::to_string(b) + " at " + at(x));
        break;
      }
    }
  }

  void compare(base_sides::place const& x, base_sides::place const& y) {
    auto& a = pieces_[3 * std::size_t{x.triangle} + x.side];
    auto& b = pieces_[3 * std::size_t{y.triangle} + y.side];
    const auto by_place = [](piece const& p, piece const& q) { return std::pair(p.t0, p.t1) < std::pair(q.t0, q.t1); };
    std::sort(a.begin(), a.end(), by_place);
    std::sort(b.begin(), b.end(), by_place);
    std::vector<piece> only_a;
    std::vector<piece> only_b;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only_a), by_place);
    std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(only_b), by_place);
    auto j = b.begin();
    for (piece const& p : a) {
      while (j != b.end() && by_place(*j, p)) ++j;
      if (j == b.end() || by_place(p, *j)) continue;
      ++report_.shared_edges;
      if (same_words(p.corner0, j->corner0) && same_words(p.corner1, j->corner1)) continue;
      ++report_.parted;
      report_.found("parted", edge_at(x.triangle, p.corner0, p.corner1) + ", shared with base triangle " + std::to_string(y.triangle));
    }
    const bool may_lack = loose(x.triangle) || loose(y.triangle);
    leftovers(x.triangle, only_a, only_b, may_lack);
    leftovers(y.triangle, only_b, only_a, may_lack);
  }

  // Pieces that the neighbour doesn't have: open edges; their ends are T-vertices where they fall inside one of the neighbour's.
  void leftovers(std::size_t b, std::vector<piece> const& mine, std::vector<piece> const& others, bool may_lack) {
    std::vector<std::pair<std::int64_t, std::uint32_t>> ends;
    for (piece const& p : mine) {
      if (!may_lack) {
        ++report_.open_edges;
        report_.found("open edge", edge_at(b, p.corner0, p.corner1));
      }
      ends.emplace_back(p.t0, p.corner0);
      ends.emplace_back(p.t1, p.corner1);
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end(), [](auto const& p, auto const& q) { return p.first == q.first; }), ends.end());
    for (auto const& [t, corner] : ends) {
      const bool inside = std::any_of(others.begin(), others.end(), [t = t](piece const& p) { return p.t0 < t && t < p.t1; });
      if (!inside) continue;
      ++report_.t_vertices;
      report_.found("T-vertex", "on a side of base triangle " + std::to_string(b) + " at " + at(corner));
    }
  }

  std::vector<golden::triangle_out> const& out_;
  std::vector<golden::triangle> const& base_;
  golden::map_regs const& map_;
  check_options options_;
  check_report& report_;
  base_sides sides_;
  std::vector<bool> forward_;
  std::vector<std::vector<piece>> pieces_;
  std::vector<std::uint32_t> first_, members_;

  // One base triangle's.
  std::vector<std::tuple<std::int64_t, std::int64_t, std::uint32_t, std::uint32_t>> order_;
  std::vector<std::uint32_t> id_, corner_;
  std::vector<std::tuple<std::uint32_t, std::uint32_t, bool>> uses_;
  std::vector<std::array<std::uint32_t, 2>> open_;
};

}  // namespace

bool has_weights(std::vector<golden::triangle_out> const& out) {
  for (auto const& t : out) {
    if (t.empty) continue;
    weights const& w = t.v[0].barycentric;
    return w[0] + w[1] + w[2] == one;
  }
  return true;  // nothing put out: the exact check says so
}

void check_exact(std::vector<golden::triangle_out> const& out, std::vector<golden::triangle> const& base, golden::map_regs const& map,
                 check_options const& options, check_report& report) {
  report.exact = true;
  report.with_base = true;
  report.with_areas = true;
  exact_checker(out, base, map, options, report).run();
}

}  // namespace relievo::tb
