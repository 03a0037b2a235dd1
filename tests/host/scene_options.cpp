// scene_options: the texts of the command line.
#include "tb/host/scene_options.hpp"

#include <gtest/gtest.h>

#include "tests/support/refuses.hpp"

namespace relievo::test {
namespace {

TEST(scene_options, texts_are_read) {
  const tb::test_selection tests = tb::parse_tests("pt,ct", "--tests");
  EXPECT_TRUE(tests.pt && tests.ct);
  EXPECT_FALSE(tests.nt || tests.sht || tests.ht || tests.vt);
  EXPECT_FALSE(tb::parse_tests("none", "--tests").nt);
  EXPECT_EQ(tb::parse_address("wrap", "--address"), (std::array<bool, 2>{true, true}));
  EXPECT_EQ(tb::parse_address("wrap,clamp", "--address"), (std::array<bool, 2>{true, false}));
  EXPECT_EQ(tb::parse_vector3("1,-2.5,+3e1", "--eye"), glm::dvec3(1, -2.5, 30));
  EXPECT_EQ(tb::parse_vector2("0.5,2", "--texel-size"), glm::dvec2(0.5, 2));
  EXPECT_EQ(tb::parse_viewport("640x480", "--viewport"), (std::array<int, 2>{640, 480}));
  EXPECT_EQ(tb::parse_sample_range("236,1076", "--sample-range").high, 1076);
  EXPECT_TRUE(tb::parse_height_mode("average", "--height-mode"));
  EXPECT_FALSE(tb::parse_queue("lifo", "--queue"));
}

TEST(scene_options, others_are_refused_with_the_options_name) {
  EXPECT_TRUE(refuses([] { tb::parse_tests("nt,xt", "--tests"); }, {"--tests", "xt"}));
  EXPECT_TRUE(refuses([] { tb::parse_tests("", "--tests"); }, {"--tests"}));
  EXPECT_TRUE(refuses([] { tb::parse_address("repeat", "--address"); }, {"--address", "repeat"}));
  EXPECT_TRUE(refuses([] { tb::parse_address("wrap,wrap,wrap", "--address"); }, {"--address"}));
  EXPECT_TRUE(refuses([] { tb::parse_vector3("1,2", "--eye"); }, {"--eye", "3 numbers", "x,y,z"}));
  EXPECT_TRUE(refuses([] { tb::parse_vector3("1,2,nan", "--eye"); }, {"--eye", "nan"}));
  EXPECT_TRUE(refuses([] { tb::parse_vector3("1,2,", "--eye"); }, {"--eye"}));
  EXPECT_TRUE(refuses([] { tb::parse_viewport("640*480", "--viewport"); }, {"--viewport", "WIDTHxHEIGHT"}));
  EXPECT_TRUE(refuses([] { tb::parse_sample_range("3,3", "--sample-range"); }, {"--sample-range", "different"}));
  EXPECT_TRUE(refuses([] { tb::parse_height_mode("mean", "--height-mode"); }, {"--height-mode", "mean"}));
  EXPECT_TRUE(refuses([] { tb::parse_queue("stack", "--queue"); }, {"--queue", "stack"}));
}

}  // namespace
}  // namespace relievo::test
