// remeshed_mesh: is what the sweep made of a triangle a mesh of that triangle?
//
//   corners_of(p)         a triangle of plain integers as the words of a kernel; remesh(kernel, p, list, most) walks it
//   remeshed_mesh m(p)    the triangle, with its edges' steps and the plane that the kernel's set-up chose
//     m.check(list)       testing::AssertionResult, exact, vertices compared by identity:
//       every projected triangle turns as (p0, p1, p2) does, none is empty unless the corners lie on one line, the areas add up;
//       every inner edge is used twice, once in each direction; the border is the three subdivided edges, in order; V - E + F = 1;
//       a walk takes no more clocks, a primitive each, than sweep_line.hpp says; no grid vertex unless |det| > n, where D_sweep and
//       D_side are needed
//     m.count_steps       histogram of the lengths of steps
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hls/sweep/sweep_line.hpp"
#include "tests/support/grid_triangles.hpp"

namespace relievo::test {

__extension__ typedef __int128 exact_int;  // areas in the common denominator of three edges
using primitive_list = std::vector<hls::primitive>;

inline hls::sweep_line_in corners_of(grid_triangle const& p) {
  hls::sweep_line_in in;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) in.p[i][axis] = hls::from_raw<formats::grid>(p[i][axis]);
  return in;
}
inline std::string text_of(hls::remeshed_vertex const& v) {
  switch (raw(v.kind)) {
    case hls::corner_vertex:
      return "P" + std::to_string(raw(v.number));
    case hls::edge_vertex:
      return "E" + std::to_string(raw(v.number)) + "." + std::to_string(raw(v.i));
    default:
      return "[" + std::to_string(raw(v.s)) + " " + std::to_string(raw(v.t)) + "]";
  }
}
inline std::string text_of(hls::primitive const& primitive) {
  std::string text = primitive.quad ? "quad" : "triangle";
  for (int i = 0; i < (primitive.quad ? 4 : 3); ++i) text += " " + text_of(primitive.v[i]);
  return text;
}
inline std::string text_of(primitive_list const& list) {
  std::string text;
  for (hls::primitive const& primitive : list) text += "\n  " + text_of(primitive);
  return text;
}

// Into a list that keeps its memory from triangle to triangle. A walk that does not end is cut off beyond its bound.
inline void remesh(hls::sweep_line& kernel, grid_triangle const& p, primitive_list& list, std::int64_t most) {
  list.clear();
  kernel.start(corners_of(p));
  bool last = false;
  while (!last && static_cast<std::int64_t>(list.size()) <= most) {
    list.emplace_back();
    last = kernel.step(list.back());
  }
}

// Numbers keys in the order in which they come.
class key_table {
 public:
  static constexpr std::size_t none = ~std::size_t{0};
  void clear(std::size_t most) {
    mask_ = 15;
    while (mask_ < 2 * most) mask_ = 2 * mask_ + 1;
    if (slot_.size() <= mask_) slot_.resize(mask_ + 1);
    std::fill_n(slot_.begin(), mask_ + 1, 0u);
    key_.clear();
  }
  std::size_t find(std::uint64_t key) const {
    const std::uint32_t slot = slot_[place(key)];
    return slot == 0 ? none : slot - 1;
  }
  std::size_t number_of(std::uint64_t key) {
    std::uint32_t& slot = slot_[place(key)];
    if (slot == 0) {
      key_.push_back(key);
      slot = static_cast<std::uint32_t>(key_.size());
    }
    return slot - 1;
  }

 private:
  std::size_t place(std::uint64_t key) const {
    std::size_t at = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> 32) & mask_;
    while (slot_[at] != 0 && key_[slot_[at] - 1] != key) at = (at + 1) & mask_;
    return at;
  }
  std::vector<std::uint32_t> slot_;  // 1 + the number; 0 is free
  std::vector<std::uint64_t> key_;
  std::size_t mask_ = 15;
};

struct step_histogram {
  // Squared length of a step between neighbours: in space along an edge (times n squared), and in the plane between grid vertices.
  double longest_on_an_edge = 0;
  std::array<std::uint64_t, 4> on_an_edge{};  // up to 1, root 2, root 3; longer
  std::array<std::uint64_t, 4> inside{};      // 1 along s, 1 along t, both (a diagonal), any other
};

class remeshed_mesh {
 public:
  explicit remeshed_mesh(grid_triangle const& p) : p_(p), setup_(hls::set_up(corners_of(p))) {
    s_ = static_cast<std::size_t>(raw(setup_.plane.s));
    t_ = static_cast<std::size_t>(raw(setup_.plane.t));
    for (std::size_t e = 0; e < 3; ++e) {
      const grid_point &from = p[e], &to = p[(e + 1) % 3];
      const std::size_t main = main_axis(from, to);
      n_[e] = std::abs(to[main] - from[main]);
      rising_[e] = from[main] <= to[main];
      common_ *= std::max(n_[e], 1);
    }
    for (std::size_t e = 0; e < 3; ++e) others_[e] = exact_int(std::max(n_[(e + 1) % 3], 1)) * std::max(n_[(e + 2) % 3], 1);
  }

  std::int64_t steps_of(std::size_t edge) const { return n_[edge]; }
  std::size_t primary() const { return static_cast<std::size_t>(raw(setup_.plane.c) + 1) % 3; }
  hls::sweep_setup const& setup() const { return setup_; }
  // Twice the area of the projection, as (p0, p1, p2) turns.
  std::int64_t determinant() const {
    const auto d = [&](std::size_t to, std::size_t axis) { return std::int64_t{p_[to][axis]} - p_[0][axis]; };
    return d(1, s_) * d(2, t_) - d(1, t_) * d(2, s_);
  }
  std::int64_t most_primitives() const {
    std::int64_t bound = std::abs(determinant()) - 4;
    for (std::size_t e = 0; e < 3; ++e) bound += std::max(n_[e], 1) * (e == primary() ? 3 : 1);
    return std::max<std::int64_t>(bound, 1);
  }

  testing::AssertionResult check(primitive_list const& list) const {
    static key_table vertices, edges;   // they keep their memory from triangle to triangle
    static std::vector<point> places;   // of the vertices, by number
    static std::vector<bool> has_twin;  // of the edges, by number
    vertices.clear(4 * list.size());
    edges.clear(6 * list.size());
    places.clear();
    has_twin.clear();
    const std::int64_t whole = determinant();
    exact_int area = 0;
    std::size_t faces = 0;
    bool twice_used = false;
    const auto number_of = [&](hls::remeshed_vertex const& v) {
      const std::size_t number = vertices.number_of(key(v));
      if (number == places.size()) places.push_back(place(v));
      return number;
    };
    const auto use = [&](std::size_t from, std::size_t to) {
      const std::size_t edge = edges.number_of(from << 32 | to);
      if (edge < has_twin.size()) twice_used = true;
      has_twin.resize(std::max(has_twin.size(), edge + 1));
      const std::size_t twin = edges.find(to << 32 | from);
      if (twin != key_table::none) has_twin[edge] = has_twin[twin] = true;
    };
    const auto face = [&](std::size_t a, std::size_t b, std::size_t c) {
      const point &pa = places[a], &pb = places[b], &pc = places[c];
      const exact_int twice = (pb.s - pa.s) * (pc.t - pa.t) - (pb.t - pa.t) * (pc.s - pa.s);
      area += twice;
      ++faces;
      use(a, b);
      use(b, c);
      use(c, a);
      return whole == 0 ? twice == 0 : (whole > 0 ? twice > 0 : twice < 0);
    };
    const bool grid_expected = std::abs(whole) > steps_of(primary());
    for (hls::primitive const& q : list) {
      std::array<std::size_t, 4> v{};
      for (std::size_t i = 0; i < (q.quad ? 4 : 3); ++i) {
        if (!is_vertex(q.v[i])) return fails(list) << "no vertex of this triangle: " << text_of(q);
        if (!grid_expected && raw(q.v[i].kind) == hls::grid_vertex) return fails(list) << "a grid vertex with |det| <= n: " << text_of(q);
        v[i] = number_of(q.v[i]);
      }
      const bool good = q.quad ? face(v[0], v[1], v[3]) & face(v[1], v[2], v[3]) : face(v[0], v[1], v[2]);
      if (!good) return fails(list) << "flipped or empty: " << text_of(q);
      if (!q.quad && key(q.v[3]) != 0) return fails(list) << "a triangle with a fourth vertex: " << text_of(q);
    }
    if (area != exact_int(whole) * common_ * common_) return fails(list) << "the areas do not add up";
    if (twice_used) return fails(list) << "an edge is used twice in one direction";

    std::size_t border = 0;
    for (std::size_t e = 0; e < 3; ++e)
      for (int i = 0; i < std::max(n_[e], 1); ++i, ++border) {
        const std::size_t from = vertices.find(key_on_edge(e, i)), to = vertices.find(key_on_edge(e, i + 1));
        const std::size_t edge = from == key_table::none || to == key_table::none ? key_table::none : edges.find(from << 32 | to);
        if (edge == key_table::none || has_twin[edge]) return fails(list) << "edge " << e << " has no border at step " << i;
      }
    const auto alone = static_cast<std::size_t>(std::count(has_twin.begin(), has_twin.end(), false));
    if (alone != border) return fails(list) << "a border within";
    if (places.size() + faces != (has_twin.size() + border) / 2 + 1) return fails(list) << "V - E + F is not 1";
    if (static_cast<std::int64_t>(list.size()) > most_primitives()) return fails(list) << "more than " << most_primitives() << " clocks";
    return testing::AssertionSuccess();
  }

  void count_steps(primitive_list const& list, step_histogram& steps) const {
    for (std::size_t e = 0; e < 3; ++e) {
      if (n_[e] == 0) continue;
      double squared = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double d = double(p_[(e + 1) % 3][axis] - p_[e][axis]) / n_[e];
        squared += d * d;
      }
      steps.longest_on_an_edge = std::max(steps.longest_on_an_edge, squared);
      const std::size_t bin = squared <= 1 ? 0 : squared <= 2 ? 1 : squared <= 3 ? 2 : 3;
      steps.on_an_edge[bin] += static_cast<std::uint64_t>(n_[e]);
    }
    const auto step = [&steps](hls::remeshed_vertex const& a, hls::remeshed_vertex const& b) {
      if (raw(a.kind) != hls::grid_vertex || raw(b.kind) != hls::grid_vertex) return;
      const std::int64_t ds = std::abs(raw(a.s) - raw(b.s)), dt = std::abs(raw(a.t) - raw(b.t));
      ++steps.inside[ds == 1 && dt == 0 ? 0 : ds == 0 && dt == 1 ? 1 : ds == 1 && dt == 1 ? 2 : 3];
    };
    for (hls::primitive const& q : list)
      for (int i = 0; i < (q.quad ? 4 : 3); ++i) step(q.v[i], q.v[(i + 1) % (q.quad ? 4 : 3)]);
  }

  // Vertices by identity.
  static std::uint64_t key(hls::remeshed_vertex const& v) {
    const auto word = [](std::int64_t x) { return static_cast<std::uint64_t>(x) & 0xffff; };
    return word(raw(v.kind)) << 50 | word(raw(v.number)) << 48 | word(raw(v.i)) << 32 | word(raw(v.s)) << 16 | word(raw(v.t));
  }

 private:
  struct point {
    exact_int s, t;
  };

  testing::AssertionResult fails(primitive_list const& list) const {
    return testing::AssertionFailure() << text_of(p_) << text_of(list) << "\n";
  }
  bool is_vertex(hls::remeshed_vertex const& v) const {
    const std::int64_t kind = raw(v.kind), number = raw(v.number), i = raw(v.i), s = raw(v.s), t = raw(v.t);
    if (number > 2 || kind > 2) return false;
    if (kind == hls::grid_vertex) return number == 0 && i == 0;
    if (s != 0 || t != 0) return false;
    return kind == hls::corner_vertex ? i == 0 : i >= 1 && i < n_[static_cast<std::size_t>(number)];
  }
  // Vertex i of an edge, counted from its corner e to its corner e + 1.
  std::uint64_t key_on_edge(std::size_t e, int i) const {
    hls::remeshed_vertex v{};
    if (i == 0 || i >= n_[e]) {
      v.number = hls::detail::two(static_cast<int>(i == 0 ? e : (e + 1) % 3));
    } else {
      v.kind = hls::detail::two(hls::edge_vertex);
      v.number = hls::detail::two(static_cast<int>(e));
      v.i = hls::from_raw<formats::steps>(rising_[e] ? i : n_[e] - i);
    }
    return key(v);
  }
  // In the remeshing plane, times the product of the edges' steps.
  point place(hls::remeshed_vertex const& v) const {
    if (raw(v.kind) == hls::grid_vertex) return {exact_int(raw(v.s)) * common_, exact_int(raw(v.t)) * common_};
    const std::size_t e = static_cast<std::size_t>(raw(v.number));
    if (raw(v.kind) == hls::corner_vertex) return {exact_int(p_[e][s_]) * common_, exact_int(p_[e][t_]) * common_};
    const grid_point &from = p_[rising_[e] ? e : (e + 1) % 3], &to = p_[rising_[e] ? (e + 1) % 3 : e];
    const auto along = [&](std::size_t axis) {
      return (exact_int(from[axis]) * n_[e] + exact_int(raw(v.i)) * (to[axis] - from[axis])) * others_[e];
    };
    return {along(s_), along(t_)};
  }

  grid_triangle p_;
  hls::sweep_setup setup_;
  std::size_t s_ = 0, t_ = 0;
  std::array<int, 3> n_{};
  std::array<bool, 3> rising_{};
  exact_int common_ = 1;               // product of the steps of all edges
  std::array<exact_int, 3> others_{};  // of the two others
};

}  // namespace relievo::test
