#include "tb/host/base_meshes.hpp"

#include <cmath>

#include "tb/host/input_error.hpp"
#include "tb/host/names.hpp"
#include "tb/host/teapot.hpp"

namespace relievo::tb {

namespace {

constexpr double pi = 3.14159265358979323846;

// Cosine and sine of i/n of a turn. i is taken modulo n and reduced to the first octant, so that a seam closes and mirrored points mirror.
glm::dvec2 on_circle(int i, int n) {
  const long turn = 8L * (((i % n) + n) % n);
  const long octant = turn / n;
  const long rest = turn - octant * n;  // eighths of a turn past the octant's start, times n
  const double along = octant % 2 == 0 ? static_cast<double>(rest) : static_cast<double>(n - rest);
  const double angle = along / static_cast<double>(n) * (pi / 4.0);
  const double c = std::cos(angle), s = std::sin(angle);
  switch (octant) {
    case 0:
      return {c, s};
    case 1:
      return {s, c};
    case 2:
      return {-s, c};
    case 3:
      return {-c, s};
    case 4:
      return {-c, -s};
    case 5:
      return {-s, -c};
    case 6:
      return {s, -c};
    default:
      return {c, -s};
  }
}

// Triangles over a grid of (columns + 1) x (rows + 1) vertices, row by row from the bottom; both diagonals run from lower left to upper
// right.
void add_grid_triangles(mesh& m, int columns, int rows) {
  const auto width = static_cast<std::uint32_t>(columns + 1);
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j) {
    for (std::uint32_t i = 0; i + 1 < width; ++i) {
      const std::uint32_t a = j * width + i, b = a + 1, c = b + width, d = a + width;
      m.triangles.push_back({a, b, c});
      m.triangles.push_back({a, c, d});
    }
  }
}

mesh make_plane(int n, glm::dvec2 samples) {
  mesh m;
  const double longer = std::fmax(samples.x, samples.y);
  const glm::dvec2 half = samples / longer;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      base_vertex v;
      v.p = glm::dvec3(half.x * (2 * i - n) / n, half.y * (2 * j - n) / n, 0.0);
      v.n = glm::dvec3(0, 0, 1);
      v.t = glm::dvec3(1, 0, 0);
      v.u = glm::dvec2(i, j) / static_cast<double>(n);
      m.vertices.push_back(v);
    }
  }
  add_grid_triangles(m, n, n);
  return m;
}

mesh make_cylinder(int around, int up) {
  mesh m;
  for (int j = 0; j <= up; ++j) {
    for (int i = 0; i <= around; ++i) {
      const glm::dvec2 c = on_circle(i, around);
      base_vertex v;
      v.p = glm::dvec3(c, static_cast<double>(2 * j - up) / up);
      v.n = glm::dvec3(c, 0.0);
      v.t = glm::dvec3(-c.y, c.x, 0.0);
      v.u = glm::dvec2(static_cast<double>(i) / around, static_cast<double>(j) / up);
      m.vertices.push_back(v);
    }
  }
  add_grid_triangles(m, around, up);
  return m;
}

mesh make_sphere(int n) {
  mesh m;
  const int around = 2 * n;
  const auto vertex_at = [&](double i, int j, glm::dvec2 longitude) {
    const glm::dvec2 latitude = on_circle(2 * j - n, 4 * n);  // -90..90 degrees in steps of 180 / n
    base_vertex v;
    v.n = glm::dvec3(longitude * latitude.x, latitude.y);
    v.p = v.n;
    v.t = glm::dvec3(-longitude.y, longitude.x, 0.0);
    v.u = glm::dvec2(i / around, static_cast<double>(j) / n);
    m.vertices.push_back(v);
  };
  for (int j = 1; j < n; ++j)
    for (int i = 0; i <= around; ++i) vertex_at(i, j, on_circle(i, around));
  add_grid_triangles(m, around, n - 2);
  const auto south = static_cast<std::uint32_t>(m.vertices.size());
  for (int i = 0; i < around; ++i) vertex_at(i + 0.5, 0, on_circle(2 * i + 1, 2 * around));
  const auto north = static_cast<std::uint32_t>(m.vertices.size());
  for (int i = 0; i < around; ++i) vertex_at(i + 0.5, n, on_circle(2 * i + 1, 2 * around));
  const auto top_row = static_cast<std::uint32_t>((n - 2) * (around + 1));
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(around); ++i) {
    m.triangles.push_back({south + i, i + 1, i});
    m.triangles.push_back({north + i, top_row + i, top_row + i + 1});
  }
  // The pole itself, whatever the cosine of 90 degrees came out as.
  for (std::uint32_t i = south; i < m.vertices.size(); ++i) m.vertices[i].p = m.vertices[i].n = glm::dvec3(0, 0, i < north ? -1 : 1);
  return m;
}

mesh make_octahedron() {
  mesh m;
  const auto add = [&](double x, double y, double z, double u, double v) {
    base_vertex b;
    b.p = b.n = glm::dvec3(x, y, z);
    b.u = glm::dvec2(u, v);
    m.vertices.push_back(b);
  };
  add(0, 0, 1, 0.5, 0.5);
  add(1, 0, 0, 1.0, 0.5);
  add(0, 1, 0, 0.5, 1.0);
  add(-1, 0, 0, 0.0, 0.5);
  add(0, -1, 0, 0.5, 0.0);
  add(0, 0, -1, 1.0, 1.0);
  add(0, 0, -1, 0.0, 1.0);
  add(0, 0, -1, 0.0, 0.0);
  add(0, 0, -1, 1.0, 0.0);
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t a = 1 + i, b = 1 + (i + 1) % 4;
    m.triangles.push_back({0, a, b});
    m.triangles.push_back({5 + i, b, a});
  }
  return m;
}

void limit(std::string const& spec, double triangles) {
  if (triangles > 1048576.0) throw input_error(spec + ": more than 1048576 triangles; a smaller number is needed");
}

}  // namespace

bool wraps_in_u(std::string const& spec) {
  return numbers_of(spec, "cylinder", 2).has_value() || numbers_of(spec, "sphere", 1).has_value();
}

std::optional<mesh> make_base_mesh(std::string const& spec, glm::dvec2 samples) {
  const auto number = [](std::vector<int> const& given, std::size_t i, int otherwise) { return i < given.size() ? given[i] : otherwise; };
  std::optional<mesh> made;
  if (const auto plane = numbers_of(spec, "plane", 1)) {
    const int n = number(*plane, 0, 8);
    limit(spec, 2.0 * n * n);
    made = make_plane(n, samples);
    made->has_tangents = true;
  } else if (const auto cylinder = numbers_of(spec, "cylinder", 2)) {
    const int around = number(*cylinder, 0, 16), up = number(*cylinder, 1, 4);
    if (around < 3) throw input_error(spec + ": a cylinder needs at least 3 quads around");
    limit(spec, 2.0 * around * up);
    made = make_cylinder(around, up);
    made->has_tangents = true;
  } else if (const auto sphere = numbers_of(spec, "sphere", 1)) {
    const int n = number(*sphere, 0, 8);
    if (n < 2) throw input_error(spec + ": a sphere needs at least 2 quads from pole to pole");
    limit(spec, 4.0 * n * n);
    made = make_sphere(n);
    made->has_tangents = true;
  } else if (numbers_of(spec, "octahedron", 0)) {
    made = make_octahedron();
  } else if (const auto teapot = numbers_of(spec, "teapot", 1)) {
    const int n = number(*teapot, 0, 4);
    limit(spec, 2.0 * 28 * n * n);
    made = make_teapot(n);
  }
  if (made) {
    made->name = spec;
    check_base_mesh(*made);
    made->planar = is_planar(*made);
  }
  return made;
}

}  // namespace relievo::tb
