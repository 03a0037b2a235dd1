// Pictures: the same bytes every time, the right thing in the right place, files that decode to what was drawn.
#include "tb/analysis/image.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>

#include "tb/analysis/shading.hpp"

namespace relievo::test {
namespace {

tb::surface hills(int n) {
  tb::surface s;
  const auto at = [n](int i, int j) {
    const double x = 2.0 * i / n - 1;
    const double y = 2.0 * j / n - 1;
    tb::surface_vertex v;
    v.p = {x, y, 0.2 * std::sin(5 * x) * std::cos(4 * y)};
    v.n = glm::normalize(glm::dvec3(-std::cos(5 * x) * std::cos(4 * y), 0.8 * std::sin(5 * x) * std::sin(4 * y), 1));
    return v;
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      s.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, 0});
      s.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}, 0});
    }
  }
  return s;
}

tb::camera_view slant(int width, int height) {
  tb::camera_view c;
  c.eye = {0, -3.5, 2.4};
  c.at = {0, 0, 0};
  c.fov_degrees = 40;
  c.width = width;
  c.height = height;
  return c;
}

std::vector<std::array<std::uint8_t, 3>> decode(std::string const& bytes, int width, int height) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
  EXPECT_EQ(static_cast<int>(image.width), width);
  EXPECT_EQ(static_cast<int>(image.height), height);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::array<std::uint8_t, 3>> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  EXPECT_TRUE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr));
  return pixels;
}

TEST(image, the_same_bytes_every_time) {
  const auto s = hills(16);
  for (const bool wireframe : {false, true}) {
    tb::image_options options;
    options.wireframe = wireframe;
    const std::string once = tb::encode_png(tb::render(s, slant(160, 100), options));
    EXPECT_EQ(once, tb::encode_png(tb::render(s, slant(160, 100), options)));
    EXPECT_LT(once.size(), 20000u);
  }
}

TEST(image, surface_in_the_middle_paper_around_it) {
  const auto image = tb::render(hills(8), slant(160, 100));
  const auto paper = tb::shading::ramp(tb::shading::background);
  EXPECT_EQ(image.pixels.front(), paper);
  EXPECT_EQ(image.pixels.back(), paper);
  EXPECT_NE(image.pixels[50 * 160 + 80], paper);
}

TEST(image, wireframe_draws_edges_where_they_project) {
  // One triangle seen from straight above: its edges are dark, its middle is as without lines.
  tb::surface s(1);
  s[0].v[0].p = {-1, -1, 0};
  s[0].v[1].p = {1, -1, 0};
  s[0].v[2].p = {0, 1, 0};
  for (auto& v : s[0].v) v.n = {0, 0, 1};
  tb::camera_view c = slant(101, 101);
  c.eye = {0, 0, 3};
  c.up = {0, 1, 0};
  c.fov_degrees = 2 * std::atan(0.5) * 180 / 3.14159265358979323846;  // 3 units across: 101 pixels
  tb::image_options lines;
  lines.wireframe = true;
  const auto plain = tb::render(s, c);
  const auto drawn = tb::render(s, c, lines);
  const auto pixel = [](tb::picture const& p, int x, int y) {
    return p.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width) + static_cast<std::size_t>(x)];
  };
  EXPECT_EQ(pixel(plain, 50, 60), pixel(drawn, 50, 60));
  // y = -1 is a third of a side below the middle: row 50.5 + 33.7.
  int darkest = 255;
  for (int y = 82; y <= 86; ++y) darkest = std::min(darkest, static_cast<int>(pixel(drawn, 50, y)[0]));
  EXPECT_LT(darkest, pixel(plain, 50, 80)[0] - 30);
}

TEST(image, nothing_to_see_is_paper) {
  const auto image = tb::render({}, slant(20, 10));
  for (auto const& p : image.pixels) EXPECT_EQ(p, tb::shading::ramp(tb::shading::background));
}

TEST(image, few_colours_and_many_decode_to_what_was_drawn) {
  tb::picture few{64, 48, {}};
  tb::picture many{64, 48, {}};
  for (int i = 0; i < 64 * 48; ++i) {
    few.pixels.push_back(tb::shading::ramp((i % 200) / 200.0));
    many.pixels.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 7), static_cast<std::uint8_t>(i * 13)});
  }
  EXPECT_EQ(decode(tb::encode_png(few), 64, 48), few.pixels);
  EXPECT_EQ(decode(tb::encode_png(many), 64, 48), many.pixels);
}

TEST(image, ramp_grows_brighter_all_the_way) {
  for (int i = 1; i < 256; ++i) {
    const auto a = tb::shading::ramp((i - 1) / 255.0);
    const auto b = tb::shading::ramp(i / 255.0);
    EXPECT_GE(b[0] + b[1] + b[2], a[0] + a[1] + a[2]);
  }
}

}  // namespace
}  // namespace relievo::test
