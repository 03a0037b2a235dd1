// view_volume_clip: hls equals golden; each plane rejects what lies wholly beyond it and nothing that touches it; what is behind the eye
// has no place on the screen; the order of the corners is all one.
#include "hls/sweep/view_volume_clip.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "golden/sweep/view_volume_clip.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {
namespace {

using vector = stimulus<hls::view_volume_clip_in, hls::view_volume_clip_regs>;

testing::AssertionResult agrees(vector const& v) {
  const auto out = hls::view_volume_clip(v.in, v.regs);
  const auto result = equal_words(
      out, golden::view_volume_clip(as_golden<golden::view_volume_clip_in>(v.in), as_golden<golden::view_volume_clip_regs>(v.regs)));
  if (!result) return result;
  vector turned = v;
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    for (int axis = 0; axis < 2; ++axis) turned.in.screen[i][axis] = v.in.screen[next][axis];
    turned.in.w[i] = v.in.w[next];
    turned.in.behind[i] = v.in.behind[next];
  }
  return hls::view_volume_clip(turned.in, v.regs).rejected == out.rejected ? result : testing::AssertionFailure() << "the order counts";
}

TEST(view_volume_clip, hls_equals_golden) { for_vectors<vector>(any_word(), agrees); }

// Each corner within a few LSB of the same plane, well inside all the others.
TEST(view_volume_clip, hls_equals_golden_at_the_planes) {
  std::uint64_t rejected = 0, seen = 0;
  for_vectors<vector>(
      [](vector& v, generator& g) {
        for (auto& size : v.regs.viewport) size = hls::from_raw<formats::screen>(400 << 8);
        v.regs.near = hls::from_raw<formats::depth>(1 << 12);
        v.regs.far = hls::from_raw<formats::depth>(1 << 24);
        const auto plane = g.below(6);
        for (int i = 0; i < 3; ++i) {
          const std::int64_t off = g.between(-1, 2) * (plane % 2 == 0 ? -1 : 1);
          for (auto& x : v.in.screen[i]) x = hls::from_raw<formats::screen>(200 << 8);
          v.in.w[i] = hls::from_raw<formats::depth>(1 << 20);
          v.in.behind[i] = g.chance(20);
          if (plane == 0) v.in.w[i] = hls::from_raw<formats::depth>((1 << 12) + off);
          if (plane == 1) v.in.w[i] = hls::from_raw<formats::depth>((1 << 24) + off);
          if (plane == 2) v.in.screen[i][0] = hls::from_raw<formats::screen>(off);
          if (plane == 3) v.in.screen[i][0] = hls::from_raw<formats::screen>((400 << 8) + off);
          if (plane == 4) v.in.screen[i][1] = hls::from_raw<formats::screen>(off);
          if (plane == 5) v.in.screen[i][1] = hls::from_raw<formats::screen>((400 << 8) + off);
        }
      },
      [&](vector const& v) {
        ++seen;
        rejected += hls::view_volume_clip(v.in, v.regs).rejected ? 1 : 0;
        return agrees(v);
      });
  EXPECT_GT(rejected, seen / 16);
  EXPECT_LT(rejected, seen / 4);
}

vector inside() {
  vector v{};
  for (auto& size : v.regs.viewport) size = hls::from_raw<formats::screen>(100 << 8);
  v.regs.near = hls::from_raw<formats::depth>(1000);
  v.regs.far = hls::from_raw<formats::depth>(2000);
  for (auto& w : v.in.w) w = hls::from_raw<formats::depth>(1500);
  for (auto& corner : v.in.screen)
    for (auto& x : corner) x = hls::from_raw<formats::screen>(50 << 8);
  return v;
}
bool rejects(vector const& v) { return hls::view_volume_clip(v.in, v.regs).rejected; }

TEST(view_volume_clip, beyond_a_side_only_with_every_corner) {
  for (int axis = 0; axis < 2; ++axis)
    for (const int x : {-1, (100 << 8) + 1}) {
      vector v = inside();
      for (int i = 0; i < 3; ++i) {
        EXPECT_FALSE(rejects(v));
        v.in.screen[i][axis] = hls::from_raw<formats::screen>(x);
      }
      EXPECT_TRUE(rejects(v));
      v.in.behind[1] = true;
      EXPECT_FALSE(rejects(v)) << "a corner behind the eye may come round to the other side";
    }
}

TEST(view_volume_clip, beyond_different_sides_is_no_rejection) {
  vector v = inside();
  v.in.screen[0][0] = hls::from_raw<formats::screen>(-1);
  v.in.screen[1][0] = hls::from_raw<formats::screen>((100 << 8) + 1);
  v.in.screen[2][1] = hls::from_raw<formats::screen>(-1);
  EXPECT_FALSE(rejects(v));
}

TEST(view_volume_clip, behind_the_eye_is_before_near) {
  vector v = inside();
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(rejects(v));
    v.in.w[i] = hls::from_raw<formats::depth>(0);
    v.in.behind[i] = true;
  }
  EXPECT_TRUE(rejects(v));
}

}  // namespace
}  // namespace relievo::test
