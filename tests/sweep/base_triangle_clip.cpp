// base_triangle_clip: hls equals golden; nothing that can be seen is rejected; the bounds themselves. Its d_max: d_max_of.cpp; a scene:
// base_triangle_clip_scene.cpp.
#include "hls/sweep/base_triangle_clip.hpp"

#include <gtest/gtest.h>

#include "golden/sweep/base_triangle_clip.hpp"
#include "tests/support/world_words.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::base_triangle_clip_in, hls::base_triangle_clip_regs>;

testing::AssertionResult agrees(vector const& v) {
  return equal_words(hls::base_triangle_clip(v.in, v.regs), golden::base_triangle_clip(as_golden<golden::base_triangle_clip_in>(v.in),
                                                                                       as_golden<golden::base_triangle_clip_regs>(v.regs)));
}

// As they come from transform and from the host.
void in_front(vector& v, generator&) {
  for (auto& w : v.in.w)
    if (raw(w) == 0) w = hls::from_raw<formats::depth>(1);
  for (auto& size : v.regs.viewport) size = hls::from_raw<formats::screen>(std::abs(raw(size) / 2));
  v.regs.d_scale = hls::from_raw<formats::matrix_w>(std::abs(raw(v.regs.d_scale) / 2));
}

TEST(base_triangle_clip, hls_equals_golden) { for_vectors<vector>(in_front, agrees); }

// Every corner within some LSB of the same bound.
void at_a_bound(vector& v, generator& g) {
  in_front(v, g);
  v.in.d_max = hls::from_raw<formats::extent>(g.between(0, 1 << g.between(1, 24)) & 0xffffff);
  const long double d = value(v.in.d_max);
  const std::uint64_t bound = g.below(6);
  const std::int64_t least = g.between(1 << 12, (1 << 27) - 1);
  for (int i = 0; i < 3; ++i) {
    v.in.w[i] = hls::from_raw<formats::depth>(i == 0 ? least : least + g.between(0, 1 << 20));
    if (bound == 4)
      v.in.w[i] =
          nearest<formats::depth>(value(v.regs.near) - value(v.regs.d_scale) * d + static_cast<long double>(g.between(-4, 4)) / (1 << 20));
    if (bound == 5)
      v.in.w[i] =
          nearest<formats::depth>(value(v.regs.far) + value(v.regs.d_scale) * d + static_cast<long double>(g.between(-4, 4)) / (1 << 20));
  }
  if (bound > 3) return;
  const int axis = bound < 2 ? 0 : 1;
  const bool low = bound % 2 == 0;
  v.regs.reach[axis] = hls::from_raw<formats::reach>(raw(v.regs.reach[axis]) >> g.below(12));
  const long double e = value(v.regs.reach[axis]) * d / value(v.in.w[0]) + 1;
  for (int i = 0; i < 3; ++i)
    v.in.screen[i][axis] =
        nearest<formats::screen>((low ? -e : value(v.regs.viewport[axis]) + e) + static_cast<long double>(g.between(-2, 2)) / 256);
}

TEST(base_triangle_clip, hls_equals_golden_at_the_bounds) {
  std::uint64_t rejected = 0, number = 0;
  for_vectors<vector>(
      at_a_bound,
      [&](vector const& v) {
        ++number;
        rejected += hls::base_triangle_clip(v.in, v.regs).rejected ? 1 : 0;
        return agrees(v);
      },
      vector_count() / 2);
  EXPECT_GT(rejected, number / 20);
  EXPECT_LT(rejected, number - number / 20);
}

// From what is seen back to a triangle that was displaced there: along the steepest way out, or any; the triangle along the side, or any.
TEST(base_triangle_clip, nothing_that_is_seen_is_rejected) {
  generator g = next_generator();
  std::uint64_t hidden = 0, seen = 0;
  for (std::uint64_t round = 0; round < vector_count() / 10; ++round) {
    const view_camera camera = draw_camera(g);
    const auto part = [&g](long double low, long double high) {
      const std::uint64_t kind = g.below(4);
      return kind == 0 ? low : kind == 1 ? high : low + (high - low) * static_cast<long double>(g.below(1 << 24)) / (1 << 24);
    };
    const long double w = part(value(camera.near), std::min(value(camera.far), value(camera.near) * 16));
    const place shown = camera.at(part(0, camera.width) * w, part(0, camera.height) * w, w);
    const place rows[3] = {place_of(camera.regs.row_x), place_of(camera.regs.row_y), place_of(camera.regs.row_w)};
    // x w >= 0, W w - x w >= 0 and so on; near and far.
    const std::size_t side = g.below(6);
    const place inward = side == 0   ? rows[0]
                         : side == 1 ? moved(moved({}, camera.width, rows[2]), -1, rows[0])
                         : side == 2 ? rows[1]
                         : side == 3 ? moved(moved({}, camera.height, rows[2]), -1, rows[1])
                                     : moved({}, side == 4 ? 1 : -1, rows[2]);
    const place n = scaled_to(g.chance(3) ? draw_direction(g) : inward, 1);
    hls::displace_in displaced{};
    for (std::size_t i = 0; i < 3; ++i) displaced.n[i] = nearest<formats::unit>(n[i]);
    const long double h = std::ldexp(1.0L, -static_cast<int>(g.below(16)));
    hls::displace_regs height{};
    height.bias = nearest<formats::height>(h);
    const place base = moved(shown, -h, place_of(displaced.n)), apart = draw_direction(g),
                other = g.chance(4) ? draw_direction(g) : across(apart, inward);
    const place along = g.chance(4) ? apart : across(other, inward);
    const long double size = std::min(h * 2, w);
    place corners[3];
    corners[0] = moved(base, size * part(0, 1), scaled_to(along, 1));
    corners[1] = moved(base, size * part(0, 1), scaled_to(other, 1));
    corners[2] = moved(moved(moved({}, 3, base), -1, corners[0]), -1, corners[1]);
    hls::base_triangle_clip_in in{};
    in.d_max = hls::from_raw<formats::extent>(raw(height.bias));
    place middle{};
    bool in_front = true, all_out = true;
    for (std::size_t i = 0; i < 3; ++i) {
      hls::transform_in corner;
      for (std::size_t k = 0; k < 3; ++k) corner.p[k] = nearest<formats::position>(corners[i][k]);
      const auto there = hls::transform(corner, camera.regs);
      for (int axis = 0; axis < 2; ++axis) in.screen[i][axis] = there.screen[axis];
      in.w[i] = there.w;
      in_front &= !there.behind;
      middle = moved(middle, 1.0L / 3, place_of(corner.p));
      all_out &= product(inward, place_of(corner.p)) < product(inward, moved(shown, -h / 2, n));
    }
    if (!in_front) continue;
    for (std::size_t i = 0; i < 3; ++i) displaced.p[i] = nearest<formats::position>(middle[i]);
    if (!camera.sees(place_of(hls::displace(displaced, height).p)) && !camera.sees(moved(middle, h, place_of(displaced.n)))) continue;
    ++seen;
    hidden += all_out ? 1 : 0;
    const vector v{in, clip_regs_of(camera)};
    ASSERT_FALSE(hls::base_triangle_clip(v.in, v.regs).rejected) << "side " << side << "\n" << describe(v);
  }
  EXPECT_GT(seen, vector_count() / 100);
  EXPECT_GT(hidden, vector_count() / 200) << "few triangles lie outside of what is seen";
}

// w = 1, reach 2, d_max 3/2: K = 3, and a pixel; a viewport of 100 x 50.
vector plain(std::int64_t x, std::int64_t y) {
  vector v{};
  for (int i = 0; i < 3; ++i) {
    v.in.screen[i][0] = hls::from_raw<formats::screen>(x);
    v.in.screen[i][1] = hls::from_raw<formats::screen>(y);
    v.in.w[i] = hls::from_raw<formats::depth>(1 << 20);
  }
  v.in.d_max = hls::from_raw<formats::extent>(3 << 19);
  v.regs.viewport[0] = hls::from_raw<formats::screen>(100 << 8);
  v.regs.viewport[1] = hls::from_raw<formats::screen>(50 << 8);
  for (auto& reach : v.regs.reach) reach = hls::from_raw<formats::reach>(2 << formats::reach::fraction);
  v.regs.near = hls::from_raw<formats::depth>(1 << 18);
  v.regs.far = hls::from_raw<formats::depth>(4 << 20);
  v.regs.d_scale = hls::from_raw<formats::matrix_w>(1 << (formats::matrix_w::fraction - 1));
  return v;
}
bool rejected(vector const& v) { return hls::base_triangle_clip(v.in, v.regs).rejected; }

TEST(base_triangle_clip, an_lsb_beyond_the_extended_bounds_is_rejected) {
  EXPECT_FALSE(rejected(plain(-4 * 256, 0)));
  EXPECT_TRUE(rejected(plain(-4 * 256 - 1, 0)));
  EXPECT_FALSE(rejected(plain(104 * 256, 0)));
  EXPECT_TRUE(rejected(plain(104 * 256 + 1, 0)));
  EXPECT_FALSE(rejected(plain(0, -4 * 256)));
  EXPECT_TRUE(rejected(plain(0, -4 * 256 - 1)));
  EXPECT_FALSE(rejected(plain(0, 54 * 256)));
  EXPECT_TRUE(rejected(plain(0, 54 * 256 + 1)));
  EXPECT_FALSE(rejected(plain(0, 0)));
  // One corner that is not beyond the side keeps it, and so does one nearer to the eye.
  for (int i = 0; i < 3; ++i) {
    vector v = plain(-4 * 256 - 1, 0);
    v.in.screen[i][0] = hls::from_raw<formats::screen>(-4 * 256);
    EXPECT_FALSE(rejected(v)) << i;
    v = plain(-4 * 256 - 1, 0);
    v.in.w[i] = hls::from_raw<formats::depth>((1 << 20) - 1400);
    EXPECT_FALSE(rejected(v)) << i;
    // Beyond one side and beyond another are not beyond the same.
    v = plain(-4 * 256 - 1, 0);
    v.in.screen[i][0] = hls::from_raw<formats::screen>(104 * 256 + 1);
    EXPECT_FALSE(rejected(v)) << i;
  }
}

TEST(base_triangle_clip, what_displacement_may_bring_behind_the_eye_is_kept) {
  vector v = plain(-8000 * 256, 0);
  EXPECT_TRUE(rejected(v));
  v.regs.d_scale = hls::from_raw<formats::matrix_w>((std::int64_t{2} << formats::matrix_w::fraction) / 3);
  EXPECT_TRUE(rejected(v)) << "d is still below w";
  v.regs.d_scale = hls::from_raw<formats::matrix_w>((std::int64_t{2} << formats::matrix_w::fraction) / 3 + 1);
  EXPECT_FALSE(rejected(v));
}

TEST(base_triangle_clip, an_lsb_beyond_near_and_far_is_rejected) {
  const auto at = [](std::int64_t w, std::int64_t near, std::int64_t far) {
    vector v = plain(50 * 256, 25 * 256);
    for (auto& depth : v.in.w) depth = hls::from_raw<formats::depth>(w);
    v.regs.near = hls::from_raw<formats::depth>(near);
    v.regs.far = hls::from_raw<formats::depth>(far);
    return v;
  };
  constexpr std::int64_t w = 10 << 20, d = 3 << 18, most = 255 << 20;
  EXPECT_FALSE(rejected(at(w, w + d + 2, most)));
  EXPECT_TRUE(rejected(at(w, w + d + 3, most)));
  EXPECT_FALSE(rejected(at(w, 1, w - d - 2)));
  EXPECT_TRUE(rejected(at(w, 1, w - d - 3)));
  for (int i = 0; i < 3; ++i) {
    vector v = at(w, w + d + 3, most);
    v.in.w[i] = hls::from_raw<formats::depth>(w + 1);
    EXPECT_FALSE(rejected(v));
    v = at(w, 1, w - d - 3);
    v.in.w[i] = hls::from_raw<formats::depth>(w - 1);
    EXPECT_FALSE(rejected(v));
  }
}

}  // namespace
}  // namespace relievo::test
