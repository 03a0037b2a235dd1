// base_meshes: counts, sizes and orientation of the meshes of our own making, and that their seams are the same bits.
#include "tb/host/base_meshes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "tests/support/refuses.hpp"

namespace relievo::test {
namespace {

tb::mesh made(std::string const& spec, glm::dvec2 samples = glm::dvec2(1.0)) { return *tb::make_base_mesh(spec, samples); }

using point = std::tuple<double, double, double>;
point as_point(glm::dvec3 p) { return {p.x, p.y, p.z}; }

// Edges by position that have no partner in the other direction.
std::size_t open_edges(tb::mesh const& m) {
  std::map<std::pair<point, point>, int> uses;
  for (auto const& t : m.triangles) {
    for (std::size_t e = 0; e < 3; ++e) {
      const point a = as_point(m.vertices[t[e]].p), b = as_point(m.vertices[t[(e + 1) % 3]].p);
      if (a == b) continue;
      a < b ? ++uses[{a, b}] : --uses[{b, a}];
    }
  }
  std::size_t open = 0;
  for (auto const& [edge, sum] : uses) open += sum != 0;
  return open;
}

void expect_sound(tb::mesh const& m) {
  for (auto const& v : m.vertices) {
    EXPECT_NEAR(glm::length(v.n), 1.0, 1e-12) << m.name;
    if (m.has_tangents) {
      EXPECT_NEAR(glm::length(v.t), 1.0, 1e-9) << m.name;
    }
    EXPECT_GE(v.u.x, 0.0) << m.name;
    EXPECT_LE(v.u.x, 1.0) << m.name;
    EXPECT_GE(v.u.y, 0.0) << m.name;
    EXPECT_LE(v.u.y, 1.0) << m.name;
  }
  // Counter-clockwise both in space, seen along the normals, and in u.
  for (auto const& t : m.triangles) {
    auto const &a = m.vertices[t[0]], &b = m.vertices[t[1]], &c = m.vertices[t[2]];
    const glm::dvec3 face = glm::cross(b.p - a.p, c.p - a.p);
    EXPECT_GT(glm::dot(face, a.n + b.n + c.n), 0.0) << m.name;
    const glm::dvec2 u1 = b.u - a.u, u2 = c.u - a.u;
    EXPECT_GT(u1.x * u2.y - u2.x * u1.y, 0.0) << m.name;
  }
}

TEST(base_meshes, plane_has_the_aspect_of_the_samples) {
  const tb::mesh m = made("plane:3", glm::dvec2(402, 343));
  EXPECT_EQ(m.triangles.size(), 18u);
  EXPECT_EQ(m.vertices.size(), 16u);
  EXPECT_TRUE(m.planar);
  expect_sound(m);
  EXPECT_EQ(m.vertices.front().p, glm::dvec3(-1, -343.0 / 402.0, 0));
  EXPECT_EQ(m.vertices.back().p, glm::dvec3(1, 343.0 / 402.0, 0));
  EXPECT_EQ(m.vertices.back().u, glm::dvec2(1, 1));
  EXPECT_EQ(made("plane", glm::dvec2(1, 10)).vertices.back().p, glm::dvec3(0.1, 1, 0));
}

TEST(base_meshes, cylinder_closes_to_the_bit) {
  for (int n : {3, 4, 5, 7, 12, 1800}) {
    const tb::mesh m = made("cylinder:" + std::to_string(n) + ",2");
    EXPECT_EQ(m.triangles.size(), static_cast<std::size_t>(4 * n));
    EXPECT_EQ(open_edges(m), static_cast<std::size_t>(2 * n));
    const auto width = static_cast<std::size_t>(n) + 1;
    for (std::size_t j = 0; j < 3; ++j) {
      auto const &left = m.vertices[j * width], &right = m.vertices[j * width + width - 1];
      EXPECT_EQ(left.p, right.p);
      EXPECT_EQ(left.n, right.n);
      EXPECT_EQ(left.t, right.t);
      EXPECT_EQ(left.u.x, 0.0);
      EXPECT_EQ(right.u.x, 1.0);
    }
    expect_sound(m);
    EXPECT_FALSE(m.planar);
  }
}

TEST(base_meshes, sphere_is_closed) {
  for (int n : {2, 3, 8}) {
    const tb::mesh m = made("sphere:" + std::to_string(n));
    EXPECT_EQ(m.triangles.size(), static_cast<std::size_t>(4 * n * n - 4 * n));
    EXPECT_EQ(open_edges(m), 0u);
    expect_sound(m);
    for (auto const& v : m.vertices) EXPECT_NEAR(glm::length(v.p), 1.0, 1e-12);
  }
}

TEST(base_meshes, octahedron_is_closed_and_folds_outside) {
  tb::mesh m = made("octahedron");
  EXPECT_EQ(m.triangles.size(), 8u);
  EXPECT_EQ(open_edges(m), 0u);
  expect_sound(m);
  EXPECT_FALSE(m.has_tangents);
}

TEST(base_meshes, teapot_patches_meet_to_the_bit) {
  for (int n : {1, 2, 4, 5}) {
    const tb::mesh m = made("teapot:" + std::to_string(n));
    // 28 patches, four of them with a row of triangles at the lid's tip.
    EXPECT_EQ(m.triangles.size(), static_cast<std::size_t>(28 * 2 * n * n - 4 * n));
    // The handle's bends are too sharp for less.
    if (n > 2) expect_sound(m);
    if (n > 1) {
      // Open are the body's foot, the lid's and the rim's edge, both ends of the handle and of the spout: rings of 4 and 2 patches.
      EXPECT_EQ(open_edges(m), static_cast<std::size_t>((3 * 4 + 4 * 2) * n));
    }
    double foot = 1e9, width = 0.0;
    for (auto const& v : m.vertices) {
      foot = std::min(foot, v.p.z);
      width = std::max(width, v.p.x);
    }
    EXPECT_NEAR(foot, 0.0, 1e-12);
    EXPECT_GT(width, 1.5);
  }
}

TEST(base_meshes, teapot_normals_agree_where_patches_are_smooth) {
  const tb::mesh m = made("teapot:4");
  std::map<point, std::vector<glm::dvec3>> at;
  for (auto const& v : m.vertices) at[as_point(v.p)].push_back(v.n);
  for (auto const& [p, normals] : at)
    for (glm::dvec3 const& n : normals) EXPECT_TRUE(n == normals[0] || glm::dot(n, normals[0]) < 0.9) << std::get<0>(p);
}

TEST(base_meshes, wrong_numbers_are_refused_and_other_names_are_not_theirs) {
  const auto making = [](std::string const& spec) { return [spec] { made(spec); }; };
  EXPECT_TRUE(refuses(making("plane:0"), {"plane:0"}));
  EXPECT_TRUE(refuses(making("plane:x"), {"plane:x"}));
  EXPECT_TRUE(refuses(making("plane:2,2"), {"plane:2,2"}));
  EXPECT_TRUE(refuses(making("plane:1000"), {"plane:1000", "1048576"}));
  EXPECT_TRUE(refuses(making("cylinder:2,2"), {"cylinder:2,2", "3"}));
  EXPECT_TRUE(refuses(making("sphere:1"), {"sphere:1", "2"}));
  EXPECT_TRUE(refuses(making("octahedron:2"), {"octahedron:2"}));
  EXPECT_FALSE(tb::make_base_mesh("planet", glm::dvec2(1)));
  EXPECT_FALSE(tb::make_base_mesh("plane.obj", glm::dvec2(1)));
  EXPECT_TRUE(tb::wraps_in_u("sphere:4"));
  EXPECT_FALSE(tb::wraps_in_u("plane:4"));
}

}  // namespace
}  // namespace relievo::test
