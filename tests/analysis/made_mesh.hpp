// made_mesh: small tessellated meshes with exact weights for the tests of the checks, and ways to break them.
#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "golden/edge/triangle.hpp"
#include "golden/surface/map_regs.hpp"

namespace relievo::test {

struct made_mesh {
  std::vector<golden::triangle> base;
  std::vector<golden::triangle_out> out;
  golden::map_regs map;
};

inline golden::vertex base_vertex_at(glm::dvec3 p, glm::dvec3 n, glm::dvec3 t, glm::dvec2 u) {
  golden::vertex v;
  v.p = p;
  v.n = n;
  v.t = t;
  v.u = u;
  return v;
}

inline golden::triangle base_triangle_of(golden::vertex const& a, golden::vertex const& b, golden::vertex const& c) {
  golden::triangle t;
  t.v[0] = a;
  t.v[1] = b;
  t.v[2] = c;
  return t;
}

// quads x quads squares in z = 0, the map's texels from corner to corner.
inline made_mesh plane(int quads, golden::map_regs const& map) {
  made_mesh m;
  m.map = map;
  const double w = map.wrap_u ? map.width : map.width - 1;
  const double h = map.wrap_v ? map.height : map.height - 1;
  const auto at = [&](int i, int j) {
    const double s = static_cast<double>(i) / quads;
    const double t = static_cast<double>(j) / quads;
    return base_vertex_at({2 * s - 1, 2 * t - 1, 0}, {0, 0, 1}, {1, 0, 0}, {s * w, t * h});
  };
  for (int j = 0; j < quads; ++j) {
    for (int i = 0; i < quads; ++i) {
      m.base.push_back(base_triangle_of(at(i, j), at(i + 1, j), at(i + 1, j + 1)));
      m.base.push_back(base_triangle_of(at(i, j), at(i + 1, j + 1), at(i, j + 1)));
    }
  }
  for (std::size_t i = 0; i < m.base.size(); ++i) m.base[i].index = static_cast<double>(i);
  return m;
}

inline double round_to_bits(double x, int fraction) { return std::ldexp(std::floor(std::ldexp(x, fraction) + 0.5), -fraction); }

// The vertex of base triangle `b` with weights w / 2^60. P and U are rounded to their formats when asked.
inline golden::out_vertex vertex_at(golden::triangle const& b, std::array<std::int64_t, 3> const& w, bool rounded) {
  golden::out_vertex v;
  v.barycentric = w;
  glm::dvec3 n(0.0);
  for (int k = 0; k < 3; ++k) {
    const double part = std::ldexp(static_cast<double>(w[static_cast<std::size_t>(k)]), -60);
    v.p += part * b.v[k].p;
    v.u += part * b.v[k].u;
    v.t += part * b.v[k].t;
    n += part * b.v[k].n;
  }
  if (rounded) {
    for (int i = 0; i < 3; ++i) v.p[i] = round_to_bits(v.p[i], 20);
    for (int i = 0; i < 2; ++i) v.u[i] = round_to_bits(v.u[i], 11);
  }
  v.displaced_p = v.p + 0.25 * std::sin(3.0 * v.p.x + 2.0 * v.p.y + v.p.z) * n;
  v.displaced_n = n;
  return v;
}

// Cuts base triangle b into n^2 (n a power of two).
inline void cut(made_mesh& m, std::size_t b, int n, bool rounded = false) {
  const std::int64_t step = (std::int64_t{1} << 60) / n;
  const auto at = [&](int i, int j) { return vertex_at(m.base[b], {(n - i - j) * step, i * step, j * step}, rounded); };
  const auto put = [&](golden::out_vertex const& p, golden::out_vertex const& q, golden::out_vertex const& r) {
    golden::triangle_out t;
    t.v[0] = p;
    t.v[1] = q;
    t.v[2] = r;
    t.index = static_cast<double>(b);
    m.out.push_back(t);
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i + j < n; ++i) {
      put(at(i, j), at(i + 1, j), at(i, j + 1));
      if (i + j + 1 < n) put(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
}

inline made_mesh cut_plane(int quads, int n, golden::map_regs const& map = {9, 9, false, false}, bool rounded = false) {
  made_mesh m = plane(quads, map);
  for (std::size_t b = 0; b < m.base.size(); ++b) cut(m, b, n, rounded);
  return m;
}

// Splits edge k of one output triangle at its middle, the neighbour none the wiser: a T-vertex unless the edge is at the border.
inline void split_alone(made_mesh& m, std::size_t triangle, int k, bool rounded = false) {
  const golden::triangle_out t = m.out[triangle];
  golden::out_vertex const& a = t.v[k];
  golden::out_vertex const& b = t.v[(k + 1) % 3];
  std::array<std::int64_t, 3> w{};
  for (std::size_t i = 0; i < 3; ++i) w[i] = (a.barycentric[i] + b.barycentric[i]) / 2;
  const golden::out_vertex middle = vertex_at(m.base[static_cast<std::size_t>(t.index)], w, rounded);
  m.out[triangle].v[(k + 1) % 3] = middle;
  golden::triangle_out other = t;
  other.v[k] = middle;
  m.out.push_back(other);
}

// Two triangles that share the positions of one edge, whose far end has another U in each: the pole of a sphere.
inline made_mesh pole() {
  made_mesh m;
  m.map = {17, 17, true, false};
  const glm::dvec3 n(0, 0, 1);
  const glm::dvec3 t(1, 0, 0);
  const auto west = base_vertex_at({-1, 0, 0}, n, t, {0, 8});
  const auto middle = base_vertex_at({0, 0, 0}, n, t, {4, 8});
  const auto east = base_vertex_at({1, 0, 0}, n, t, {8, 8});
  m.base.push_back(base_triangle_of(west, middle, base_vertex_at({0, 1, 0}, n, t, {2, 16})));
  m.base.push_back(base_triangle_of(middle, east, base_vertex_at({0, 1, 0}, n, t, {6, 16})));
  m.base[1].index = 1;
  return m;
}

inline void drop_weights(made_mesh& m) {
  for (auto& t : m.out) {
    for (auto& v : t.v) v.barycentric = {};
  }
}

}  // namespace relievo::test
