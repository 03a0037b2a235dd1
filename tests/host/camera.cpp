// camera: where points land on the screen, that nothing in the cube saturates, and what is refused.
#include "tb/host/camera.hpp"

#include <gtest/gtest.h>

#include <random>

#include "golden/surface/transform.hpp"
#include "golden/surface/transform_normal.hpp"
#include "tests/support/refuses.hpp"
#include "tests/support/settings.hpp"

namespace relievo::test {
namespace {

tb::camera_view from(glm::dvec3 eye, glm::dvec3 at = glm::dvec3(0)) {
  tb::camera_view view;
  view.eye = eye;
  view.at = at;
  view.fov_degrees = 60;
  view.width = 640;
  view.height = 480;
  return view;
}

golden::transform_out project(tb::camera_registers const& camera, glm::dvec3 p) {
  return golden::transform<golden::rounded>({p}, camera.transform);
}

TEST(camera, the_point_looked_at_is_the_middle_of_the_viewport) {
  const auto camera = tb::make_camera_registers(from({3, -7, 4}));
  EXPECT_NEAR(project(camera, glm::dvec3(0)).screen.x, 320, 1.0 / 128);
  EXPECT_NEAR(project(camera, glm::dvec3(0)).screen.y, 240, 1.0 / 128);
  EXPECT_NEAR(project(camera, glm::dvec3(0)).w, std::sqrt(74.0), 1e-5);
}

TEST(camera, x_is_right_y_is_down_and_the_field_of_view_vertical) {
  const auto camera = tb::make_camera_registers(from({0, -4, 0}));
  // At distance 4, half the height is 4 tan 30 degrees.
  const double half = 4 * std::tan(std::acos(-1.0) / 6);
  EXPECT_NEAR(project(camera, {0, 0, half}).screen.y, 0, 0.01);
  EXPECT_NEAR(project(camera, {0, 0, -half}).screen.y, 480, 0.01);
  EXPECT_NEAR(project(camera, {half * 640 / 480, 0, 0}).screen.x, 640, 0.01);
  const auto toward = golden::transform_normal<golden::rounded>({glm::dvec3(0), {0, -1, 0}}, camera.transform_normal);
  EXPECT_EQ(toward.n, glm::dvec3(0, 0, -1));
  EXPECT_FALSE(toward.away);
  EXPECT_EQ(golden::transform_normal<golden::rounded>({glm::dvec3(0), {1, 0, 0}}, camera.transform_normal).n, glm::dvec3(1, 0, 0));
  EXPECT_EQ(golden::transform_normal<golden::rounded>({glm::dvec3(0), {0, 0, 1}}, camera.transform_normal).n, glm::dvec3(0, -1, 0));
}

TEST(camera, at_and_behind_the_eye_is_behind) {
  const auto camera = tb::make_camera_registers(from({0, -4, 0}));
  EXPECT_TRUE(project(camera, {0, -4, 0}).behind);
  EXPECT_TRUE(project(camera, {0, -5, 0}).behind);
  EXPECT_TRUE(project(camera, {0, -4 + 1.0 / 512, 0}).behind);
  EXPECT_FALSE(project(camera, {0, -4 + 1.0 / 128, 0}).behind);
}

TEST(camera, clip_and_w_never_saturate_in_the_cube) {
  std::mt19937_64 random(seed());
  std::uniform_real_distribution<double> part(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    tb::camera_view view = from({part(random) * 127, part(random) * 127, part(random) * 127}, {part(random), part(random), part(random)});
    view.fov_degrees = 1.0 + 170.0 * std::abs(part(random));
    view.width = 1 + static_cast<int>(8190 * std::abs(part(random)));
    view.height = 1 + static_cast<int>(8190 * std::abs(part(random)));
    tb::camera_registers camera;
    try {
      camera = tb::make_camera_registers(view);
    } catch (tb::input_error const&) {
      continue;
    }
    auto const& t = camera.transform;
    ASSERT_GT(t.w_min, 0);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p((corner & 1) ? 8 : -8, (corner & 2) ? 8 : -8, (corner & 4) ? 8 : -8);
      ASSERT_LT(std::abs(glm::dot(t.row_x, p) + t.offset_x), 131072);
      ASSERT_LT(std::abs(glm::dot(t.row_y, p) + t.offset_y), 131072);
      ASSERT_LT(glm::dot(t.row_w, p) + t.offset_w, 256);
    }
  }
}

TEST(camera, rows_are_scaled_by_a_power_of_two_where_they_must) {
  tb::camera_view view = from({0, -20, 0});
  EXPECT_EQ(tb::make_camera_registers(view).row_exponent, 0);
  view.fov_degrees = 3;
  const auto camera = tb::make_camera_registers(view);
  EXPECT_LT(camera.row_exponent, 0);
  EXPECT_EQ(camera.transform.w_min, std::ldexp(1.0, camera.row_exponent - 8));
  EXPECT_NEAR(project(camera, {0, 0, 0.1}).screen.y, 240 - 0.1 / 20 * 240 / std::tan(1.5 * std::acos(-1.0) / 180), 0.1);
}

TEST(camera, refuses_what_is_no_view) {
  const auto making = [](tb::camera_view view) { return [view] { tb::make_camera_registers(view); }; };
  EXPECT_TRUE(refuses(making(from({1, 2, 3}, {1, 2, 3})), {"--eye", "--at"}));
  EXPECT_TRUE(refuses(making(from({0, 0, 5})), {"--up"}));
  EXPECT_TRUE(refuses(making(from({NAN, 0, 5})), {"--eye", "finite"}));
  EXPECT_TRUE(refuses(making(from({200, 0, 0})), {"--eye", "128"}));
  tb::camera_view view = from({0, -4, 0});
  view.fov_degrees = 180;
  EXPECT_TRUE(refuses(making(view), {"--fov", "175"}));
  view = from({0, -4, 0});
  view.width = 0;
  EXPECT_TRUE(refuses(making(view), {"--viewport", "8191"}));
  view = from({0, -4, 0});
  view.far = view.near;
  EXPECT_TRUE(refuses(making(view), {"--near", "--far"}));
  view = from({120, 0, 0}, {120, 7, 0});
  view.fov_degrees = 0.1;
  view.height = 8191;
  EXPECT_TRUE(refuses(making(view), {"does not fit"}));
}

TEST(camera, the_default_view_holds_the_box) {
  const glm::dvec3 low(-0.5, -0.75, 0), high(1.5, 1.25, 0.3);
  for (double fov : {10.0, 40.0, 100.0}) {
    for (int width : {200, 2000}) {
      for (glm::dvec3 up : {glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0), glm::dvec3(1, 1, 1)}) {
        tb::camera_view view = from({0, 0, 0});
        view.fov_degrees = fov;
        view.width = width;
        view.up = up;
        const auto camera = tb::make_camera_registers(tb::look_at_box(view, low, high));
        double nearest = 1e9;
        for (int corner = 0; corner < 8; ++corner) {
          const auto out = project(camera, glm::mix(low, high, glm::bvec3((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0)));
          EXPECT_FALSE(out.behind);
          nearest = std::min({nearest, out.screen.x, width - out.screen.x, out.screen.y, 480 - out.screen.y});
        }
        EXPECT_GE(nearest, 0.0);
        EXPECT_LE(nearest, 0.15 * std::min(width, 480));
      }
    }
  }
}

}  // namespace
}  // namespace relievo::test
