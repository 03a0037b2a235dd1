// near_clip_golden: cut triangles in golden alone. Every register of a cut against whole numbers of 128 bits; the polygon against the
// triangle and the planes in real numbers, place by place; what is untouched, what is empty, and how many vertices a polygon gets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/support/world_views.hpp"

namespace relievo::test {
namespace {

using namespace golden;
using golden::detail::int128;

bool same_words(base_vertex const& a, base_vertex const& b) {
  return a.p == b.p && a.n == b.n && a.t == b.t && a.u == b.u && a.colour == b.colour;
}

// r = floor(A / (A + B) + 1/2) in LSB of ratio, every attribute floor(a + (b - a) r + 1/2) in its own.
void expect_cut(base_vertex const& a, base_vertex const& b, std::int64_t da, std::int64_t db) {
  const double lsb = 0x1p-20;
  const base_vertex got = cut_vertex(a, b, static_cast<double>(da) * lsb, static_cast<double>(db) * lsb);
  ASSERT_TRUE(same_words(got, cut_vertex(b, a, static_cast<double>(db) * lsb, static_cast<double>(da) * lsb)));
  std::int64_t from = std::abs(da), to = std::abs(db);
  while (std::max(from, to) >= 1 << 25) {
    from >>= 1;
    to >>= 1;
  }
  const std::int64_t sum = from + to, r = ((from << 26) + sum) / (2 * sum);
  const auto expected = [r](auto f, double x, double y) {
    const std::int64_t first = word<decltype(f)>(x), second = word<decltype(f)>(y);
    return static_cast<std::int64_t>((static_cast<int128>(first) * (1 << 25) + static_cast<int128>(second - first) * r + (1 << 24)) >> 25);
  };
  normalize_in n, t;
  t.tangent = true;
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(word<formats::position>(got.p[k]), expected(formats::position{}, a.p[k], b.p[k]));
    n.v[k] = static_cast<double>(expected(formats::unit{}, a.n[k], b.n[k])) * range_of<formats::direction>::lsb;
    t.v[k] = static_cast<double>(expected(formats::unit{}, a.t[k], b.t[k])) * range_of<formats::direction>::lsb;
  }
  ASSERT_EQ(got.n, normalize<rounded>(n).n);
  ASSERT_EQ(got.t, normalize<rounded>(t).n);
  for (int k = 0; k < 2; ++k) ASSERT_EQ(word<formats::coordinate>(got.u[k]), expected(formats::coordinate{}, a.u[k], b.u[k]));
  for (int k = 0; k < 4; ++k) ASSERT_EQ(word<formats::colour>(got.colour[k]), expected(formats::colour{}, a.colour[k], b.colour[k]));
}

TEST(near_clip_golden, a_cut_is_rounded_at_each_register_and_has_no_direction) {
  draw d(seed());
  base_vertex extreme[2];
  each_attribute(
      [](auto f, double& low, double& high) {
        low = range_of<typename decltype(f)::given>::min;
        high = range_of<typename decltype(f)::given>::max;
      },
      extreme[0], extreme[1]);
  // Of lengths beyond those that units have, n and t are normalised all the same.
  for (int k = 0; k <= 45; ++k)
    for (int off = -1; off <= 1; ++off) {
      const std::int64_t long_one = std::max<std::int64_t>(1, (std::int64_t{1} << k) + off);
      for (const std::int64_t short_one : {std::int64_t{0}, std::int64_t{1}, long_one / 3, long_one - 1, long_one}) {
        expect_cut(extreme[0], extreme[1], short_one, -long_one);
        expect_cut(extreme[1], extreme[0], short_one, -long_one);
      }
    }
  for (std::uint64_t i = 0; i < rounds(5) && !HasFailure(); ++i) {
    const std::int64_t inside = static_cast<std::int64_t>(std::exp2(d.real(0, 45))) - 1,
                       outside = -static_cast<std::int64_t>(std::exp2(d.real(0, 45)));
    base_vertex a = draw_base_vertex(d), b = draw_base_vertex(d);
    if (d.coin()) b.p.x = a.p.x;
    if (d.coin()) b.p.y = a.p.y;
    if (d.integer(0, 3) == 0) b.t = -a.t;
    expect_cut(a, b, inside, outside);
  }
}

// ---- the polygon in the plane of its triangle, seen along the largest component of the normal ---------------------------

struct seen_triangle {
  real_vector corner[3];
  int first = 0, second = 1;

  explicit seen_triangle(near_clip_in const& in) {
    for (int i = 0; i < 3; ++i) corner[i] = real_vector(in.vertex[i].p);
    const real_vector normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]), size = glm::abs(normal);
    const int along = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    first = (along + 1) % 3;
    second = (along + 2) % 3;
    if (normal[along] < 0) std::swap(first, second);
  }
  long double side(real_vector const& a, real_vector const& b, real_vector const& q) const {
    return (b[first] - a[first]) * (q[second] - a[second]) - (b[second] - a[second]) * (q[first] - a[first]);
  }
  // At least 4 LSB from every edge, so that no rounding of cuts on it reaches q.
  bool holds(real_vector const& q) const {
    for (int i = 0; i < 3; ++i) {
      real_vector const &a = corner[i], &b = corner[(i + 1) % 3];
      if (side(a, b, q) <= std::hypot(b[first] - a[first], b[second] - a[second]) * 0x1p-18L) return false;
    }
    return true;
  }
  // How often the polygon goes around q.
  int turns(near_clip_out const& polygon, real_vector const& q) const {
    int turns = 0;
    for (int i = 0; i < polygon.count; ++i) {
      const real_vector a(polygon.vertex[i].p), b(polygon.vertex[(i + 1) % polygon.count].p);
      const bool a_below = a[second] <= q[second], b_below = b[second] <= q[second];
      if (a_below && !b_below && side(a, b, q) > 0) ++turns;
      if (!a_below && b_below && side(a, b, q) < 0) --turns;
    }
    return turns;
  }
};

struct polygon_meter {
  double most[6] = {};
  std::uint64_t within = 0, beyond = 0, counts[10] = {}, overflows = 0;

  void triangle(draw& d, world_view const& view, near_clip_in const& in) {
    const near_clip_out out = near_clip(in, view.clip);
    ++counts[out.count];
    overflows += out.overflow;
    ASSERT_EQ(out.empty, out.count == 0);
    ASSERT_TRUE(out.empty || out.count >= 3) << out.count;
    for (int i = out.count; i < clipped_vertices_max; ++i) ASSERT_TRUE(same_words(out.vertex[i], base_vertex()));

    long double tolerance[6] = {};
    bool all_within = true, none_within = false;
    for (const clip_plane plane : all_clip_planes) {
      if (!is_used(plane, view.clip)) continue;
      const auto k = static_cast<std::size_t>(plane);
      long double low = 1e30L, high = -1e30L;
      for (base_vertex const& v : in.vertex) {
        low = std::min(low, view.real(plane, v.p));
        high = std::max(high, view.real(plane, v.p));
      }
      // The planes after this one may cut on it again.
      tolerance[k] = view.tolerance(plane, high - low) + static_cast<long double>(5 - k) * view.half_position(plane);
      all_within &= low >= world_view::half_registers(plane);
      none_within |= high < -world_view::half_registers(plane);
      for (int i = 0; i < out.count; ++i) {
        const long double off = -view.real(plane, out.vertex[i].p) / tolerance[k];
        ASSERT_LE(off, 1) << "vertex " << i << " is beyond plane " << k;
        most[k] = std::max(most[k], static_cast<double>(off));
      }
    }
    ASSERT_TRUE(out.inside || !all_within);
    ASSERT_TRUE(out.empty || !none_within);
    if (out.inside) {
      ASSERT_EQ(out.count, 3);
      for (int i = 0; i < 3; ++i) ASSERT_TRUE(same_words(out.vertex[i], in.vertex[i]));
    }
    const seen_triangle seen(in);
    for (int n = 0; n < 8; ++n) place(d, view, in, seen, out, tolerance);
  }

  void place(draw& d, world_view const& view, near_clip_in const& in, seen_triangle const& seen, near_clip_out const& out,
             long double const (&tolerance)[6]) {
    const long double x = std::sqrt(d.real(0, 1)), y = d.real(0, 1);
    const int first = d.integer(0, 2);
    const auto corner = [&](int i) { return real_vector(in.vertex[(first + i) % 3].p); };
    const real_vector q = corner(0) * (1 - x) + corner(1) * (x * (1 - y)) + corner(2) * (x * y);
    if (!seen.holds(q)) return;
    bool inside = true, outside = false;
    for (const clip_plane plane : all_clip_planes) {
      if (!is_used(plane, view.clip)) continue;
      const long double margin = tolerance[static_cast<std::size_t>(plane)] + view.half_position(plane);
      inside &= view.real(plane, q) > margin;
      outside |= view.real(plane, q) < -margin;
    }
    if (inside) {
      ++within;
      ASSERT_EQ(seen.turns(out, q), 1) << "a place is lost";
    } else if (outside) {
      ++beyond;
      ASSERT_EQ(seen.turns(out, q), 0) << "a place is too much";
    }
  }
};

TEST(near_clip_golden, the_polygon_is_what_of_the_triangle_lies_within_the_planes) {
  draw d(seed());
  polygon_meter meter;
  for (std::uint64_t n = 0; n < rounds(500) + 200 && !HasFailure(); ++n) {
    const world_view view = draw_view(d);
    for (int i = 0; i < 40 && !HasFailure(); ++i) meter.triangle(d, view, draw_triangle_at(d, view));
  }
  std::printf("vertices beyond a plane, of the tolerance: near %.2f far %.2f left %.2f right %.2f top %.2f bottom %.2f\n", meter.most[0],
              meter.most[1], meter.most[2], meter.most[3], meter.most[4], meter.most[5]);
  std::printf("places within %llu, beyond %llu; polygons by their vertices:", static_cast<unsigned long long>(meter.within),
              static_cast<unsigned long long>(meter.beyond));
  for (int i = 0; i <= clipped_vertices_max; ++i) std::printf(" %d: %llu", i, static_cast<unsigned long long>(meter.counts[i]));
  std::printf("\n");
  for (const double most : meter.most) EXPECT_GT(most, 0.2) << "the vectors do not come near the tolerance";
  EXPECT_EQ(meter.overflows, 0U) << "a camera's triangle has more than nine vertices";
  for (const int i : {0, 3, 4, 5, 6}) EXPECT_GT(meter.counts[i], 0U) << i;
  EXPECT_GT(meter.within, meter.counts[3]);
  EXPECT_GT(meter.beyond, meter.counts[3]);
}

}  // namespace
}  // namespace relievo::test
