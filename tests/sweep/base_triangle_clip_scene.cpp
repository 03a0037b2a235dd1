// base_triangle_clip on a scene: the Jacksboro terrain, seen from low above it. How many base triangles are rejected with the d_max of the
// whole map, and with that of each triangle's own part of it (3.3: "better clipping results can be obtained"); nothing that is seen is.
#include <gtest/gtest.h>

#include "hls/surface/map_sampler.hpp"
#include "tb/model/hls_words.hpp"
#include "tests/support/jacksboro.hpp"
#include "tests/support/pyramids.hpp"
#include "tests/support/world_words.hpp"

namespace relievo::test {
namespace {

struct seen_from {
  view_camera camera;
  hls::base_triangle_clip_regs regs{};

  seen_from(glm::dvec3 const& eye, glm::dvec3 const& at) {
    const tb::camera_view view{eye, at, {0, 0, 1}, 50, 0.02, 100, 1280, 800};
    const tb::camera_registers made = tb::make_camera_registers(view);
    EXPECT_TRUE(tb::to_hls(made.transform, camera.regs));
    const long double scale = std::ldexp(1.0L, made.row_exponent);
    camera.near = nearest<formats::depth>(view.near * scale);
    camera.far = nearest<formats::depth>(std::min(view.far * scale, 255.0L));
    camera.width = view.width;
    camera.height = view.height;
    regs = clip_regs_of(camera);
  }
};

hls::displace_in inside(hls::triangle const& triangle, long double a, long double b) {
  hls::displace_in in{};
  place p{}, n{};
  const long double weights[3] = {a, b, 1 - a - b};
  for (std::size_t i = 0; i < 3; ++i) {
    p = moved(p, weights[i], place_of(triangle.v[i].p));
    n = moved(n, weights[i], place_of(triangle.v[i].n));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    in.p[i] = nearest<formats::position>(p[i]);
    in.n[i] = nearest<formats::unit>(scaled_to(n, 1)[i]);
  }
  return in;
}

TEST(base_triangle_clip_scene, the_triangles_own_d_max_saves_more) {
  tb::scene_options options = jacksboro();
  options.mesh = "plane:32";
  const tb::scene scene = tb::make_scene(options);
  const tb::hls_words words(scene);
  const pyramids map(scene.map);
  hls::displace_regs const& heights = words.regs().displace;
  hls::d_max_of_in whole{};
  whole.high[0] = hls::from_raw<formats::coordinate>(coordinate_limit(map.regs.width, map.regs.wrap_u));
  whole.high[1] = hls::from_raw<formats::coordinate>(coordinate_limit(map.regs.height, map.regs.wrap_v));
  const auto whole_d = map.at(whole, heights).d_max;

  generator g = next_generator();
  std::uint64_t triangles = 0, with_the_maps = 0, with_their_own = 0, hidden = 0;
  for (int view = 0; view < 16; ++view) {
    const glm::dvec3 eye = scene.from_world({0.25 * (view % 4) - 0.4, 0.25 * (view / 4) - 0.4, 0.35});
    const seen_from camera(eye, eye + glm::dvec3(std::cos(view), std::sin(view), -0.3));
    for (hls::triangle const& triangle : words.triangles()) {
      hls::base_triangle_clip_in in{};
      hls::d_max_of_in box{};
      bool in_front = true;
      for (int i = 0; i < 3; ++i) {
        const auto there = hls::transform({{triangle.v[i].p[0], triangle.v[i].p[1], triangle.v[i].p[2]}}, camera.camera.regs);
        in.w[i] = there.w;
        in_front &= !there.behind;
        for (int axis = 0; axis < 2; ++axis) {
          in.screen[i][axis] = there.screen[axis];
          const auto u = triangle.v[i].u[axis];
          if (i == 0 || u < box.low[axis]) box.low[axis] = u;
          if (i == 0 || u > box.high[axis]) box.high[axis] = u;
        }
      }
      if (!in_front) continue;  // near_clip's
      ++triangles;
      in.d_max = whole_d;
      const bool by_the_map = hls::base_triangle_clip(in, camera.regs).rejected;
      in.d_max = map.at(box, heights).d_max;
      ASSERT_LE(raw(in.d_max), raw(whole_d));
      const bool by_its_own = hls::base_triangle_clip(in, camera.regs).rejected;
      ASSERT_TRUE(by_its_own || !by_the_map);
      with_the_maps += by_the_map ? 1 : 0;
      with_their_own += by_its_own ? 1 : 0;
      bool seen = false;
      for (int sample = 0; sample < 8; ++sample) {
        const long double a = static_cast<long double>(g.below(1024)) / 1024, b = (1 - a) * static_cast<long double>(g.below(1024)) / 1024;
        hls::displace_in point = inside(triangle, a, b);
        hls::map_sampler_in at{};
        for (std::size_t axis = 0; axis < 2; ++axis)
          at.u[axis] = nearest<formats::coordinate>(a * value(triangle.v[0].u[axis]) + b * value(triangle.v[1].u[axis]) +
                                                    (1 - a - b) * value(triangle.v[2].u[axis]));
        point.d = hls::map_sampler(at, map.regs, {map.texels.data()}).d;
        seen |= camera.camera.sees(place_of(hls::displace(point, heights).p));
      }
      hidden += seen ? 0 : 1;
      ASSERT_FALSE(seen && by_its_own) << describe(in);
    }
  }
  std::printf(
      "%llu base triangles before the eye in 16 views, %llu of them seen in none of 8 places: %llu rejected by the map's d_max, %llu by "
      "their own\n",
      static_cast<unsigned long long>(triangles), static_cast<unsigned long long>(hidden), static_cast<unsigned long long>(with_the_maps),
      static_cast<unsigned long long>(with_their_own));
  EXPECT_GT(with_their_own, with_the_maps);
}

}  // namespace
}  // namespace relievo::test
