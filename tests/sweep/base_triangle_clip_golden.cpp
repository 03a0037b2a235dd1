// base_triangle_clip_golden: no triangle is rejected of which a displaced place is seen, and none is kept that lies beyond its bound by
// more than the allowance; d_max_of against every texel and samples of the map.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>
#include <vector>

#include "golden/surface/map_sampler.hpp"
#include "tb/host/level_words.hpp"
#include "tests/support/world_views.hpp"

namespace relievo::test {
namespace {

using namespace golden;

// The view volume in real numbers, as (x, y, w): w from near to far and (x, y) / w within the viewport.
bool is_seen(world_view const& view, real_vector const& p) {
  const real_vector q = view.projected(p);
  const auto within = [&q](long double x, double size) { return x >= 0 && x <= size * q.z; };
  return q.z >= view.clip.near && q.z <= view.clip.far && within(q.x, view.camera.width) && within(q.y, view.camera.height);
}

// Outward normals of the volume's planes in the world: left, right, top, bottom, near, far.
glm::dvec3 outward(world_view const& view, int side) {
  transform_regs const& t = view.rows();
  const glm::dvec3 normals[6] = {-t.row_x, t.row_x - t.row_w * static_cast<double>(view.camera.width),
                                 -t.row_y, t.row_y - t.row_w * static_cast<double>(view.camera.height),
                                 -t.row_w, t.row_w};
  return glm::normalize(normals[side]);
}

// A place on that plane of the volume, often on its rim.
glm::dvec3 on_plane(draw& d, world_view const& view, int side) {
  const auto within = [&d] { return d.integer(0, 3) == 0 ? d.integer(0, 1) : d.real(0, 1); };
  double x = within(), y = within();
  const double near = view.clip.near, far = view.clip.far, depth = within();
  double w = d.coin() ? near + (far - near) * depth : near * std::pow(far / near, depth);
  if (side < 2) x = side;
  if (side == 2 || side == 3) y = side - 2;
  if (side >= 4) w = side == 4 ? near : far;
  return view.place(x * view.camera.width, y * view.camera.height, w);
}

struct base_triangle_words {
  glm::dvec3 p[3];
  base_triangle_clip_in in;
};

// As the engine has it: transform's words. False where a corner is nearer than near_clip leaves any, or off the screen's format.
bool in_front(world_view const& view, base_triangle_words& triangle) {
  const double least = 0x1p-20 * std::max(view.camera.width, view.camera.height);
  for (int i = 0; i < 3; ++i) {
    const auto out = transform<rounded>({triangle.p[i]}, view.rows());
    if (out.behind || out.saturated || out.w < least) return false;
    triangle.in.screen[i] = out.screen;
    triangle.in.w[i] = out.w;
  }
  return true;
}

// Corners about as far outside of one plane as the displacement reaches. A corner of the three may be anywhere.
base_triangle_words draw_beyond(draw& d, world_view const& view, double d_max) {
  const int side = d.integer(0, 5);
  base_triangle_words out;
  out.in.d_max = d_max;
  const glm::dvec3 start = on_plane(d, view, side), away = outward(view, side);
  const double size = std::exp2(d.real(-14, 1));
  for (glm::dvec3& p : out.p) {
    const double far_out = d_max * (1 + (d.integer(0, 7) == 0 ? -1 : 1) * std::exp2(d.real(-9, 2)));
    const glm::dvec3 along = glm::cross(away, d.direction()) * (d.coin() ? size : d.real(0, 1e-4));
    p = to_position(start + along + away * (d.integer(0, 19) == 0 ? d.real(-4, 4) : far_out));
  }
  return out;
}

bool in_cube(base_triangle_words const& triangle) {
  return std::all_of(triangle.p, triangle.p + 3, [](glm::dvec3 const& p) { return glm::all(glm::lessThan(glm::abs(p), glm::dvec3(7.9))); });
}

TEST(base_triangle_clip_golden, nothing_that_is_seen_is_rejected) {
  draw d(seed());
  std::uint64_t rejected = 0, kept = 0, seen = 0;
  for (std::uint64_t n = 0; n < rounds(100) + 200; ++n) {
    const world_view view = draw_view(d);
    for (int k = 0; k < 40; ++k) {
      const double height = rounded::at<formats::height>(std::exp2(d.real(-20, 2)));
      base_triangle_words triangle = draw_beyond(d, view, height + extent_allowance);
      if (!in_cube(triangle) || !in_front(view, triangle)) continue;
      const bool out = base_triangle_clip(triangle.in, view.reject).rejected;
      ++(out ? rejected : kept);
      if (!out) continue;
      for (int i = 0; i < 30; ++i) {
        // On a corner, an edge or within; displaced towards one plane of the volume, or anywhere, by a unit's words.
        const double x = d.integer(0, 2) == 0 ? 0 : std::sqrt(d.real(0, 1)), y = d.integer(0, 2) == 0 ? 0 : d.real(0, 1);
        const int first = d.integer(0, 2);
        const auto corner = [&](int j) { return real_vector(triangle.p[(first + j) % 3]); };
        const real_vector base =
            corner(0) * (1.0L - x) + corner(1) * static_cast<long double>(x * (1 - y)) + corner(2) * static_cast<long double>(x * y);
        const glm::dvec3 to = d.integer(0, 3) == 0 ? d.direction() : -outward(view, d.integer(0, 5));
        const real_vector moved =
            base + real_vector(draw::to_unit(to)) * static_cast<long double>(d.coin() ? height : d.real(-height, height));
        // The register of the displaced position, the worst way.
        const real_vector worst = moved + real_vector(to) * (0x1p-21L * 1.7320508L);
        ASSERT_FALSE(is_seen(view, worst)) << "d " << height;
        ++seen;
      }
    }
  }
  std::printf("%llu triangles rejected, %llu kept, %llu displaced places looked at\n", static_cast<unsigned long long>(rejected),
              static_cast<unsigned long long>(kept), static_cast<unsigned long long>(seen));
  EXPECT_GT(rejected, rounds(100));
  EXPECT_GT(kept, rounds(100));
}

// Beyond the bound by more than the allowance: it must go. Otherwise a unit that rejects nothing would do.
TEST(base_triangle_clip_golden, what_is_beyond_the_bound_is_rejected) {
  draw d(seed());
  std::uint64_t counts[7] = {};
  for (std::uint64_t n = 0; n < rounds(100) + 200; ++n) {
    const world_view view = draw_view(d);
    for (int k = 0; k < 40; ++k) {
      base_triangle_words triangle = draw_beyond(d, view, rounded::at<formats::extent>(std::exp2(d.real(-20, 2))));
      if (!in_cube(triangle) || !in_front(view, triangle)) continue;
      base_triangle_clip_in const& in = triangle.in;
      const long double extent = in.d_max, depth = extent * view.reject.d_scale, least = std::min({in.w[0], in.w[1], in.w[2]});
      int beyond[6] = {};
      for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 2; ++axis) {
          const long double e = extent * view.reject.reach[axis] / least, x = in.screen[i][axis];
          beyond[2 * axis] += x < -e - 1;
          beyond[2 * axis + 1] += x > view.reject.viewport[axis] + e + 1;
        }
        beyond[4] += in.w[i] < view.clip.near - depth - 0x1p-19L;
        beyond[5] += in.w[i] > view.clip.far + depth + 0x1p-19L;
      }
      bool right = false;
      for (int side = 0; side < 6; ++side) {
        const bool all = beyond[side] == 3 && (side >= 4 || least > depth);
        counts[side] += all;
        right |= all;
      }
      counts[6] += !right;
      ASSERT_EQ(base_triangle_clip(in, view.reject).rejected, right);
    }
  }
  for (const std::uint64_t count : counts) EXPECT_GT(count, rounds(100) / 20);
}

// Three corners beyond three planes, or so near that the displacement passes the eye: nobody knows, so it stays.
TEST(base_triangle_clip_golden, what_may_be_seen_stays) {
  base_triangle_clip_regs regs;
  regs.viewport = {640, 480};
  regs.reach = {800, 700};
  regs.near = 0.1875;
  regs.far = 100;
  regs.d_scale = 1;
  base_triangle_clip_in in;
  const auto set = [&in](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, double w) {
    in.screen[0] = a;
    in.screen[1] = b;
    in.screen[2] = c;
    in.w[0] = in.w[1] = in.w[2] = w;
  };
  in.d_max = 0.125;
  set({-300, 0}, {-300, 90}, {-400, 0}, 1);
  EXPECT_TRUE(base_triangle_clip(in, regs).rejected);
  set({-300, 0}, {940, 90}, {0, -500}, 1);
  EXPECT_FALSE(base_triangle_clip(in, regs).rejected);
  set({-300, 0}, {-300, 90}, {-400, 0}, 0.125);
  EXPECT_FALSE(base_triangle_clip(in, regs).rejected) << "w_ref is the displacement";
  // E = 100 + 1 pixels, to the last bit: -101 is kept, 1/256 more is not.
  set({-101, 0}, {-101 - 1.0 / 256, 90}, {-400, 0}, 1);
  EXPECT_FALSE(base_triangle_clip(in, regs).rejected);
  set({-101 - 1.0 / 256, 0}, {-101 - 1.0 / 256, 90}, {-400, 0}, 1);
  EXPECT_TRUE(base_triangle_clip(in, regs).rejected);
}

// ---- d_max_of ------------------------------------------------------------------------------------------------------------

struct levelled_map {
  tb::displacement_map map;
  map_regs regs;
  std::vector<tb::displacement_map> maximum, minimum;

  explicit levelled_map(draw& d) {
    map.width = d.integer(0, 4) == 0 ? 1 << d.integer(0, 6) : d.integer(1, 70);
    map.height = d.integer(0, 4) == 0 ? 1 << d.integer(0, 6) : d.integer(1, 70);
    map.wrap_u = d.coin();
    map.wrap_v = d.coin();
    const bool spikes = d.coin();
    for (int i = 0; i < map.width * map.height; ++i)
      map.texels.push_back(static_cast<std::uint16_t>(spikes && d.integer(0, 40) > 0 ? d.integer(30000, 30010) : d.integer(0, 65535)));
    regs = {static_cast<double>(map.width), static_cast<double>(map.height), map.wrap_u, map.wrap_v};
    for (int l = 0; l < tb::levels_of(map.width, map.height); ++l) {
      maximum.push_back(tb::extreme_level(map, l, tb::extreme::maximum));
      minimum.push_back(tb::extreme_level(map, l, tb::extreme::minimum));
    }
  }
  double texel(int x, int y) const {
    return map
        .texels[static_cast<std::size_t>(y % map.height) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(x % map.width)];
  }
};

TEST(base_triangle_clip_golden, d_max_of_a_box_is_above_every_sample_in_it) {
  draw d(seed());
  std::uint64_t levels[8] = {}, tight = 0, boxes = 0;
  for (std::uint64_t n = 0; n < rounds(5000) + 60; ++n) {
    const levelled_map m(d);
    displace_regs regs;
    regs.scale = d.word<formats::scale>(-0x1p-13, 0x1p-13);
    regs.bias = d.coin() ? 0 : d.word<formats::height>(-2, 2);
    const auto height = [&](double sample) { return std::abs(rounded::at<formats::height>(regs.scale * sample + regs.bias)); };
    const auto ends = std::minmax_element(m.map.texels.begin(), m.map.texels.end());
    const double whole = std::max(height(*ends.first), height(*ends.second));
    for (int k = 0; k < 40; ++k) {
      d_max_of_in in;
      const double size = std::exp2(d.real(-11, 7));
      for (int axis = 0; axis < 2; ++axis) {
        const bool wraps = axis == 0 ? m.map.wrap_u : m.map.wrap_v;
        const double most = (axis == 0 ? m.map.width : m.map.height) - (wraps ? 0 : 1);
        const auto end = [&](double x) {
          return std::clamp(rounded::at<formats::coordinate>(d.integer(0, 3) == 0 ? std::floor(x) : x), 0.0, most);
        };
        in.low[axis] = end(d.real(-0.1, 1) * most);
        in.high[axis] = std::max(in.low[axis], end(in.low[axis] + d.real(0, 1) * size));
      }
      std::set<std::pair<int, int>> read[2];
      int level[2] = {-1, -1};
      const auto reader = [&](int which, std::vector<tb::displacement_map> const& of) {
        return [&, which](int l, int x, int y) {
          tb::displacement_map const& words = of.at(static_cast<std::size_t>(l));
          EXPECT_TRUE(x >= 0 && x < words.width && y >= 0 && y < words.height);
          EXPECT_TRUE(level[which] == -1 || level[which] == l);
          level[which] = l;
          read[which].insert({x, y});
          return words.texels[static_cast<std::size_t>(y * words.width + x)];
        };
      };
      const double d_max = d_max_of(in, m.regs, regs, reader(0, m.maximum), reader(1, m.minimum)).d_max;
      ASSERT_LE(std::max(read[0].size(), read[1].size()), 4U);
      EXPECT_GT(word<formats::extent>(d_max), 0);
      ++levels[std::min(level[0], 7)];

      // Every texel that a sample in the box is made of, by brute force.
      double largest = 0;
      for (int y = static_cast<int>(std::floor(in.low.y)); y <= static_cast<int>(std::ceil(in.high.y)); ++y)
        for (int x = static_cast<int>(std::floor(in.low.x)); x <= static_cast<int>(std::ceil(in.high.x)); ++x)
          largest = std::max(largest, height(m.texel(x, y)));
      ASSERT_GE(d_max, largest + extent_allowance) << "level " << level[0];
      ASSERT_LE(d_max, whole + extent_allowance);
      ++boxes;
      tight += d_max == largest + extent_allowance;

      // And the displacement itself, with the roundings of the sample, the normal and the position.
      for (int i = 0; i < 4; ++i) {
        const glm::dvec2 u(rounded::at<formats::coordinate>(d.real(in.low.x, in.high.x)),
                           rounded::at<formats::coordinate>(d.real(in.low.y, in.high.y)));
        const double sample = map_sampler<rounded>({u}, m.regs, [&m](int x, int y) { return m.texel(x, y); }).d;
        const displace_in there{d.words<formats::position>(-3, 3), d.unit(), sample};
        const auto out = displace<rounded>(there, regs);
        const long double moved = glm::length(real_vector(out.p) - real_vector(there.p));
        ASSERT_TRUE(out.saturated || moved <= d_max * (1 + 0x1p-13L)) << moved;
      }
    }
  }
  std::printf("boxes by level:");
  for (const std::uint64_t count : levels) std::printf(" %llu", static_cast<unsigned long long>(count));
  std::printf("; %.0f %% have the largest displacement itself\n", 100.0 * static_cast<double>(tight) / static_cast<double>(boxes));
  for (int l = 0; l < 6; ++l) EXPECT_GT(levels[l], 0U) << l;
  EXPECT_GT(tight, boxes / 2);
}

}  // namespace
}  // namespace relievo::test
