// map: orientation, widening and ranges of the readers, and that each kind of bad input is refused with its line.
#include "tb/host/map.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>

#include "tb/host/png_codec.hpp"
#include "tests/support/refuses.hpp"
#include "tests/support/temporary_folder.hpp"

namespace relievo::test {
namespace {

using texels = std::vector<std::uint16_t>;

auto pgm(std::string const& bytes) {
  return [bytes] { return tb::read_pgm(bytes, "a.pgm"); };
}
auto png(std::string const& bytes) {
  return [bytes] { return tb::read_png(bytes, "a.png"); };
}

std::string exr(std::vector<float> const& values, int width, int height, std::vector<std::string> const& channels, Imf::PixelType type) {
  const temporary_folder folder;
  const std::string path = folder.file("a.exr");
  Imf::Header header(width, height);
  Imf::FrameBuffer frame;
  std::vector<std::uint32_t> integers(values.size(), 1);
  for (auto const& c : channels) {
    header.channels().insert(c, Imf::Channel(type));
    char* base = type == Imf::UINT ? reinterpret_cast<char*>(integers.data()) : reinterpret_cast<char*>(const_cast<float*>(values.data()));
    frame.insert(c, Imf::Slice(type, base, 4, 4 * static_cast<std::size_t>(width)));
  }
  {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(height);
  }
  return temporary_folder::bytes_of(path);
}

TEST(map_pgm, the_bottom_row_is_row_0) {
  const tb::displacement_map text = pgm("P2\n# two by three\n2 3\n# largest\n65535\n1 2\n3 4\n5 6\n")();
  EXPECT_EQ(text.width, 2);
  EXPECT_EQ(text.height, 3);
  EXPECT_EQ(text.texels, (texels{5, 6, 3, 4, 1, 2}));
  EXPECT_EQ(pgm(std::string("P5 2 3 65535\n\0\1\0\2\0\3\0\4\0\5\1\6", 25))().texels, (texels{5, 262, 3, 4, 1, 2}));
}

TEST(map_pgm, other_ranges_are_widened) {
  EXPECT_EQ(pgm(std::string("P5\n3 1\n255\n\0\1\377", 14))().texels, (texels{0, 257, 65535}));
  EXPECT_EQ(pgm("P2 3 1 1000 0 500 1000")().texels, (texels{0, 32768, 65535}));
}

TEST(map_pgm, refuses_bad_files) {
  EXPECT_TRUE(refuses(pgm(""), {"a.pgm", "P5"}));
  EXPECT_TRUE(refuses(pgm("P6 1 1 255 abc"), {"a.pgm", "P5 or P2"}));
  EXPECT_TRUE(refuses(pgm("P2"), {"a.pgm"}));
  EXPECT_TRUE(refuses(pgm("P2 2"), {"height", "ends early"}));
  EXPECT_TRUE(refuses(pgm("P2 x 1 255 0"), {"width", "not a number"}));
  EXPECT_TRUE(refuses(pgm("P2 0 1 255"), {"width is 0", "8192"}));
  EXPECT_TRUE(refuses(pgm("P2 1 8193 255 0"), {"height is 8193", "8192"}));
  EXPECT_TRUE(refuses(pgm("P2 99999999999 1 255 0"), {"width"}));
  EXPECT_TRUE(refuses(pgm("P2 1 1 65536 0"), {"largest value is 65536"}));
  EXPECT_TRUE(refuses(pgm("P2 1 1 0 0"), {"largest value is 0"}));
  EXPECT_TRUE(refuses(pgm("P2 2 1 255 7"), {"ends early"}));
  EXPECT_TRUE(refuses(pgm("P2 2 1 255 7 256"), {"256", "above the largest value 255"}));
  EXPECT_TRUE(refuses(pgm("P2 2 1 255 7 -1"), {"not a number"}));
  EXPECT_TRUE(refuses(pgm("P5 4 1 255\nabc"), {"ends early", "4 bytes", "3 are there"}));
  EXPECT_TRUE(refuses(pgm("P5 4 1 65535\nabcd"), {"one byte a sample", "needs two"}));
  EXPECT_TRUE(refuses(pgm("P5 4 1 65535\nabcdefg"), {"ends early", "8 bytes"}));
  EXPECT_TRUE(refuses(pgm("P5 8000 8000 65535\nx"), {"ends early"}));
}

TEST(map_png, grey_of_8_and_16_bits) {
  const tb::displacement_map wide = png(tb::encode_png16(2, 2, 1, {1, 2, 3, 65535}))();
  EXPECT_EQ(wide.texels, (texels{3, 65535, 1, 2}));
  EXPECT_EQ(png(tb::encode_png8(2, 2, 1, {0, 1, 2, 255}))().texels, (texels{514, 65535, 0, 257}));
}

TEST(map_png, colour_only_where_it_is_grey) {
  EXPECT_EQ(png(tb::encode_png8(2, 1, 3, {7, 7, 7, 9, 9, 9}))().texels, (texels{7 * 257, 9 * 257}));
  EXPECT_TRUE(refuses(png(tb::encode_png8(2, 1, 3, {7, 7, 7, 9, 9, 8})), {"a.png", "colour", "grey"}));
}

TEST(map_png, refuses_damaged_files) {
  const std::string whole = tb::encode_png16(40, 30, 1, texels(1200, 12345));
  for (std::size_t size = 0; size + 12 < whole.size(); ++size) EXPECT_TRUE(refuses(png(whole.substr(0, size)), {"a.png"})) << size;
  std::string damaged = whole;
  damaged[20] = static_cast<char>(damaged[20] ^ 1);
  EXPECT_TRUE(refuses(png(damaged), {"a.png"}));
  EXPECT_TRUE(refuses(png("GIF89a whatever"), {"a.png", "no PNG"}));
}

TEST(map_png, refuses_sizes_beyond_8192) {
  EXPECT_EQ(png(tb::encode_png8(8192, 1, 1, std::vector<std::uint8_t>(8192, 1)))().width, 8192);
  EXPECT_TRUE(refuses(png(tb::encode_png8(8193, 1, 1, std::vector<std::uint8_t>(8193, 1))), {"a.png", "8192"}));
}

TEST(map_png, what_we_write_comes_back_and_is_the_same_bytes) {
  const temporary_folder folder;
  const tb::displacement_map map = *tb::generate_map("half-donut:37,21");
  tb::write_map(map, folder.file("a.png"));
  tb::write_map(map, folder.file("b.png"));
  EXPECT_EQ(tb::read_map(folder.file("a.png"), {}).texels, map.texels);
  EXPECT_EQ(temporary_folder::bytes_of(folder.file("a.png")), temporary_folder::bytes_of(folder.file("b.png")));
  EXPECT_TRUE(refuses([&] { tb::write_map(map, folder.file("none/a.png")); }, {"none/a.png", "cannot be written"}));
  EXPECT_EQ(folder.entries(), 2u);
}

TEST(map_exr, unit_range_and_sample_range) {
  const std::string bytes = exr({0.0f, 0.25f, 0.5f, 1.0f}, 2, 2, {"Y"}, Imf::FLOAT);
  EXPECT_EQ(tb::read_exr(bytes, "a.exr", {}).texels, (texels{32768, 65535, 0, 16384}));
  EXPECT_EQ(tb::read_exr(bytes, "a.exr", tb::sample_range{-1.0, 1.0}).texels, (texels{49151, 65535, 32768, 40959}));
  EXPECT_EQ(tb::read_exr(exr({0.5f}, 1, 1, {"height"}, Imf::FLOAT), "a.exr", {}).texels, (texels{32768}));
}

TEST(map_exr, refuses_bad_files) {
  const auto reading = [](std::string const& bytes) { return [bytes] { tb::read_exr(bytes, "a.exr", {}); }; };
  EXPECT_TRUE(refuses(reading(exr({0.0f, 3.0f}, 2, 1, {"Y"}, Imf::FLOAT)), {"a.exr", "0 to 3", "--sample-range 0,3"}));
  EXPECT_TRUE(refuses(reading(exr({0.0f, NAN}, 2, 1, {"Y"}, Imf::FLOAT)), {"a.exr", "not finite"}));
  EXPECT_TRUE(refuses(reading(exr({0.0f, 0.0f}, 2, 1, {"R", "G", "B"}, Imf::FLOAT)), {"a.exr", "3 channels"}));
  EXPECT_TRUE(refuses(reading(exr({0.0f, 0.0f}, 2, 1, {"Y"}, Imf::UINT)), {"a.exr", "integers"}));
  EXPECT_TRUE(refuses(reading("no exr"), {"a.exr", "unusable"}));
  const std::string whole = exr(std::vector<float>(64, 0.5f), 8, 8, {"Y"}, Imf::FLOAT);
  for (std::size_t size = 0; size < whole.size(); size += 11) EXPECT_TRUE(refuses(reading(whole.substr(0, size)), {"a.exr"})) << size;
}

TEST(map, files_are_named_in_the_message) {
  const temporary_folder folder;
  EXPECT_TRUE(refuses([&] { tb::load_map(folder.file("none.png"), {}); }, {"none.png", "no such file"}));
  EXPECT_TRUE(refuses([&] { tb::load_map(folder.put("empty.pgm", ""), {}); }, {"empty.pgm", "empty"}));
  EXPECT_TRUE(refuses([&] { tb::load_map(folder.put("a.tif", "x"), {}); }, {"a.tif", ".png, .pgm or .exr"}));
  EXPECT_TRUE(refuses([&] { tb::load_map("half-doughnut", {}); }, {"half-doughnut", "half-donut"}));
}

TEST(map, generators_are_what_they_are_called) {
  for (char const* name : {"half-donut", "sine", "checker", "text", "constant", "maximum", "ramp"}) {
    const tb::displacement_map map = *tb::generate_map(name);
    EXPECT_EQ(map.width, 256) << name;
    EXPECT_EQ(map.height, 256) << name;
    for (std::string const size : {":1,1", ":2,2", ":1,9", ":8192,1"}) EXPECT_TRUE(tb::generate_map(name + size)) << name << size;
  }
  const auto extremes = [](char const* spec) { return tb::measure(*tb::generate_map(spec)); };
  EXPECT_EQ(extremes("constant").min, extremes("constant").max);
  EXPECT_EQ(extremes("maximum").min, 65535);
  EXPECT_EQ(extremes("checker").max_delta_u, 65535 * 1);
  EXPECT_EQ(extremes("ramp:17,3").max_delta_u, 2 * 4096);
  EXPECT_EQ(extremes("ramp:17,3").max_delta_v, 0);
  const tb::displacement_map donut = *tb::generate_map("half-donut:101");
  EXPECT_EQ(donut.at(50, 50), 0);
  EXPECT_EQ(donut.at(80, 50), 65535);
  for (int y = 0; y < 101; ++y)
    for (int x = 0; x < 101; ++x) ASSERT_EQ(donut.at(x, y), donut.at(100 - x, y));
}

TEST(map, text_reads_from_left_to_right_and_bottom_to_top) {
  // The R's leg is at the bottom, its bowl at the top; the L has its bar at the bottom.
  const tb::displacement_map map = *tb::generate_map("text:410,100");
  const auto dot = [&](double x, double y) { return map.at(static_cast<int>(205 + (x - 20.5) * 8), static_cast<int>(50 + (y - 3.5) * 8)); };
  EXPECT_GT(dot(0.5, 0.5), 60000);
  EXPECT_GT(dot(2.5, 6.5), 60000);
  EXPECT_EQ(dot(2.5, 0.5), 0);
  EXPECT_GT(dot(2 * 6 + 3.5, 0.5), 60000);
  EXPECT_EQ(dot(2 * 6 + 3.5, 6.5), 0);
}

TEST(map, generators_refuse_wrong_numbers) {
  const auto making = [](std::string const& spec) { return [spec] { tb::generate_map(spec); }; };
  EXPECT_TRUE(refuses(making("sine:0"), {"sine:0", "whole numbers"}));
  EXPECT_TRUE(refuses(making("sine:8193"), {"sine:8193", "8192"}));
  EXPECT_TRUE(refuses(making("sine:4,4,4"), {"sine:4,4,4", "up to 2"}));
  EXPECT_TRUE(refuses(making("sine:"), {"sine:"}));
  EXPECT_TRUE(refuses(making("sine:4x4"), {"sine:4x4"}));
}

TEST(map, differences_follow_the_borders) {
  tb::displacement_map map;
  map.width = 4;
  map.height = 3;
  map.texels = {0, 10, 15, 100, 0, 0, 0, 0, 7, 0, 0, 0};
  tb::map_extremes e = tb::measure(map);
  EXPECT_EQ(e.max_delta_u, 170);  // one-sided at the right border: 2 (100 - 15)
  EXPECT_EQ(e.max_delta_v, 200);
  map.wrap_u = map.wrap_v = true;
  e = tb::measure(map);
  EXPECT_EQ(e.max_delta_u, 90);  // |100 - 10|; across the seam |10 - 100|, |0 - 15|
  EXPECT_EQ(e.max_delta_v, 100);
  map.width = map.height = 1;
  map.texels = {9};
  e = tb::measure(map);
  EXPECT_EQ(e.max_delta_u, 0);
  EXPECT_EQ(e.max_delta_v, 0);
}

TEST(map, jacksboro_has_its_range_in_metres) {
  const tb::displacement_map map = tb::read_map(RELIEVO_SOURCE_DIR "/tests/data/jacksboro_403x344.png", tb::sample_range{236, 1076});
  EXPECT_EQ(map.width, 403);
  EXPECT_EQ(map.height, 344);
  const tb::map_extremes e = tb::measure(map);
  EXPECT_EQ(e.min, 0);
  EXPECT_EQ(e.max, 65535);
  // Every sample stands for a whole metre.
  for (std::uint16_t sample : map.texels) {
    const int above = static_cast<int>((sample * 840 + 32767) / 65535);
    ASSERT_EQ(sample, (above * 65535 * 2 + 840) / 1680);
  }
}

}  // namespace
}  // namespace relievo::test
