// near_clip against its planes in long double: a cut lies on its plane and has the data of its place; the polygon is the triangle within
// the planes.
#include <gtest/gtest.h>

#include <array>

#include "tests/support/clipped_triangles.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::near_clip_in, hls::near_clip_regs>;

struct exact_vertex {
  place p, n;
  std::array<long double, 6> data;  // u, colour
};
exact_vertex exact_of(hls::base_vertex const& v) {
  exact_vertex e{place_of(v.p), place_of(v.n), {}};
  for (std::size_t i = 0; i < 2; ++i) e.data[i] = value(v.u[i]);
  for (std::size_t i = 0; i < 4; ++i) e.data[2 + i] = value(v.colour[i]);
  return e;
}
exact_vertex exact_between(exact_vertex const& a, exact_vertex const& b, long double r) {
  exact_vertex e;
  for (std::size_t i = 0; i < 3; ++i) {
    e.p[i] = a.p[i] + (b.p[i] - a.p[i]) * r;
    e.n[i] = a.n[i] + (b.n[i] - a.n[i]) * r;
  }
  for (std::size_t i = 0; i < 6; ++i) e.data[i] = a.data[i] + (b.data[i] - a.data[i]) * r;
  return e;
}

constexpr long double lsb = 1.0L / (1 << formats::position::fraction);
constexpr std::size_t guard_planes = 2;

std::size_t planes(clipped_view const& s) { return s.regs.guard ? 6 : guard_planes; }
long double distance(clipped_view const& s, std::size_t plane, place const& p) {
  const long double w = s.camera.depth(p);
  if (plane == 0) return w - value(s.regs.near);
  if (plane == 1) return value(s.regs.far) - w;
  const long double across = s.camera.clip(p, plane < 4 ? 0 : 1);
  return 8190 * w + (plane % 2 == 0 ? across : -across);
}
// What the roundings of w, and of x or y, move it by.
long double noise(std::size_t plane) { return (plane < guard_planes ? 1 : 8191) * lsb / 2; }

// An edge that one plane cuts: the vertex lies where the plane does, and has the data of that place.
testing::AssertionResult lies_on_the_plane(clipped_view const& s, std::size_t plane, hls::base_vertex const& inside,
                                           hls::base_vertex const& outside, hls::base_vertex const& cut) {
  const exact_vertex a = exact_of(inside), b = exact_of(outside), got = exact_of(cut);
  const long double da = distance(s, plane, a.p), db = distance(s, plane, b.p), all = da - db - 2 * noise(plane);
  if (all <= 4 * noise(plane)) return testing::AssertionSuccess();
  const long double off = 2 * noise(plane) / all + std::ldexp(1.0L, -24) + std::ldexp(1.0L, -26);
  const exact_vertex right = exact_between(a, b, da / (da - db));
  const auto within = [off](long double x, long double exact, long double difference, long double half) {
    return std::abs(x - exact) <= std::abs(difference) * off + half * 1.001L;
  };
  for (std::size_t i = 0; i < 3; ++i)
    if (!within(got.p[i], right.p[i], b.p[i] - a.p[i], lsb / 2)) return testing::AssertionFailure() << "p[" << i << "]";
  for (std::size_t i = 0; i < 6; ++i)
    if (!within(got.data[i], right.data[i], b.data[i] - a.data[i],
                std::ldexp(0.5L, i < 2 ? -formats::coordinate::fraction : -formats::colour::fraction)))
      return testing::AssertionFailure() << (i < 2 ? "u" : "colour");
  const long double length = std::sqrt(product(right.n, right.n)), half_unit = std::ldexp(1.0L, -15);
  const place across = moved(b.n, -1, a.n);
  const long double turned = std::sqrt(product(across, across)) * off + 1.7321L * half_unit;
  if (length < 2 * turned) return testing::AssertionSuccess();
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(got.n[i] - right.n[i] / length) > 2 * turned / (2 * length - turned) + half_unit)
      return testing::AssertionFailure() << "n";
  return testing::AssertionSuccess();
}

TEST(near_clip_exact, a_cut_lies_on_its_plane_with_the_data_of_its_place) {
  generator g = next_generator();
  std::array<std::uint64_t, 6> cuts{};
  for (std::uint64_t round = 0; round < vector_count() / 50 + 4000; ++round) {
    const clipped_view s(g);
    const hls::base_vertex a = s.corner(g), b = s.corner(g);
    std::size_t plane = 6;
    for (std::size_t i = 0; i < planes(s); ++i)
      if (distance(s, i, place_of(a.p)) < noise(i) || distance(s, i, place_of(b.p)) < noise(i)) plane = plane == 6 ? i : 7;
    if (plane > 5 || distance(s, plane, place_of(a.p)) < noise(plane) || distance(s, plane, place_of(b.p)) > -noise(plane)) continue;
    const polygon there = vertices_of(hls::near_clip({{a, b, b}}, s.regs));
    if (there.size() != 3) continue;  // the cut is a hair beyond another plane, or its own
    ++cuts[plane];
    ASSERT_TRUE(lies_on_the_plane(s, plane, a, b, there[1])) << "plane " << plane << "\n" << describe(vector{{{a, b, b}}, s.regs});
  }
  for (const std::uint64_t n : cuts) EXPECT_GT(n, 0U);
}

// Twice the area, as a vector.
place area_of(std::vector<exact_vertex> const& p) {
  place sum{};
  for (std::size_t i = 2; i < p.size(); ++i) sum = moved(sum, 1, across(moved(p[i - 1].p, -1, p[0].p), moved(p[i].p, -1, p[0].p)));
  return sum;
}

std::vector<exact_vertex> exactly_clipped(clipped_view const& s, std::vector<exact_vertex> p) {
  for (std::size_t plane = 0; plane < planes(s); ++plane) {
    std::vector<exact_vertex> out;
    for (std::size_t i = 0; i < p.size(); ++i) {
      exact_vertex const &a = p[i], &b = p[(i + 1) % p.size()];
      const long double da = distance(s, plane, a.p), db = distance(s, plane, b.p);
      if (da >= 0) out.push_back(a);
      if ((da >= 0) != (db >= 0)) out.push_back(exact_between(a, b, da / (da - db)));
    }
    p = out;
  }
  return p;
}

// How fast the distance changes within the triangle.
long double slope(clipped_view const& s, std::size_t plane, std::vector<exact_vertex> const& p) {
  const place u = moved(p[1].p, -1, p[0].p), v = moved(p[2].p, -1, p[0].p), normal = across(u, v);
  const long double d = distance(s, plane, p[0].p), du = distance(s, plane, p[1].p) - d, dv = distance(s, plane, p[2].p) - d;
  return std::sqrt(std::max(du * du * product(v, v) - 2 * du * dv * product(u, v) + dv * dv * product(u, u), 0.0L) /
                   product(normal, normal));
}

// The fan covers what the planes leave. A plane is off by its noise and the rounding of a position, over its slope, along the longest edge.
TEST(near_clip_exact, the_polygon_is_the_triangle_within_the_planes) {
  generator g = next_generator();
  const std::uint64_t rounds = vector_count() / 50 + 4000;
  std::uint64_t compared = 0, corners = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const clipped_view s(g);
    const hls::near_clip_in in = {{s.corner(g), s.corner(g), s.corner(g)}};
    const std::vector<exact_vertex> whole = {exact_of(in.vertex[0]), exact_of(in.vertex[1]), exact_of(in.vertex[2])};
    const place all = area_of(whole);
    if (product(all, all) < 1e-16L) continue;
    long double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const place edge = moved(whole[(i + 1) % 3].p, -1, whole[i].p);
      longest = std::max(longest, std::sqrt(product(edge, edge)));
    }
    long double allowed = 9 * 2 * longest * lsb;
    for (std::size_t plane = 0; plane < planes(s); ++plane)
      allowed += 2 * longest * (2 * noise(plane) / slope(s, plane, whole) + longest * std::ldexp(1.0L, -24));
    const auto out = hls::near_clip(in, s.regs);
    ASSERT_FALSE(out.overflow);
    std::vector<exact_vertex> got;
    for (hls::base_vertex const& v : vertices_of(out)) got.push_back(exact_of(v));
    const place area = area_of(got), right = area_of(exactly_clipped(s, whole)), off = moved(area, -1, right);
    ASSERT_LE(std::sqrt(product(off, off)), allowed) << describe(vector{in, s.regs});
    if (out.inside || out.empty || product(right, right) < 1e6L * allowed * allowed) continue;
    ++compared;
    corners += got.size() > 4 ? 1 : 0;
  }
  EXPECT_GT(compared, rounds / 40);
  EXPECT_GT(corners, rounds / 1000);
}

}  // namespace
}  // namespace relievo::test
