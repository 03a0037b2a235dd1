// read_glb: what we write comes back in the same axes; container and accessors are checked.
#include <gtest/gtest.h>

#include <cstring>

#include "tb/host/base_meshes.hpp"
#include "tb/host/read_mesh.hpp"
#include "tb/host/write_formats.hpp"
#include "tests/support/refuses.hpp"

namespace relievo::test {
namespace {

tb::mesh cylinder() { return *tb::make_base_mesh("cylinder:4,2", glm::dvec2(1.0)); }

auto reading(std::string const& bytes) {
  return [bytes] { tb::read_glb(bytes, "a.glb"); };
}

// The same container with `from` replaced by `to`, of the same length, in its JSON.
std::string with(std::string bytes, std::string const& from, std::string const& to) {
  EXPECT_EQ(from.size(), to.size());
  const auto at = bytes.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return bytes.replace(at, from.size(), to);
}

TEST(read_glb, what_we_write_comes_back) {
  tb::mesh m = cylinder();
  for (auto const& v : m.vertices) m.undisplaced.push_back(v.p * 0.5);
  const tb::mesh back = tb::read_glb(tb::glb_bytes(m, "a.glb"), "a.glb");
  ASSERT_EQ(back.vertices.size(), m.vertices.size());
  EXPECT_EQ(back.triangles, m.triangles);
  EXPECT_TRUE(back.has_tangents);
  for (std::size_t i = 0; i < m.vertices.size(); ++i) {
    EXPECT_LT(glm::length(back.vertices[i].p - m.vertices[i].p), 1e-6);
    EXPECT_LT(glm::length(back.vertices[i].n - m.vertices[i].n), 1e-6);
    EXPECT_LT(glm::length(back.vertices[i].t - m.vertices[i].t), 1e-6);
    EXPECT_LT(glm::length(back.vertices[i].u - m.vertices[i].u), 1e-6);
    EXPECT_LT(glm::length(back.undisplaced[i] - m.undisplaced[i]), 1e-6);
  }
}

TEST(read_glb, refuses_what_is_no_container) {
  const std::string whole = tb::glb_bytes(cylinder(), "a.glb");
  EXPECT_TRUE(refuses(reading("glTF"), {"a.glb", "glTF"}));
  EXPECT_TRUE(refuses(reading("{\"asset\":{\"version\":\"2.0\"}}"), {"a.glb", "glTF"}));
  for (std::size_t size = 0; size < whole.size(); size += 7) EXPECT_TRUE(refuses(reading(whole.substr(0, size)), {"a.glb"})) << size;
}

TEST(read_glb, refuses_accessors_beyond_their_buffers) {
  const std::string whole = tb::glb_bytes(cylinder(), "a.glb");
  EXPECT_TRUE(refuses(reading(with(whole, "\"count\":15", "\"count\":99")), {"a.glb"}));
  EXPECT_TRUE(refuses(reading(with(whole, "\"count\":48", "\"count\":47")), {"multiple of three"}));
  EXPECT_TRUE(refuses(reading(with(whole, "\"POSITION\"", "\"POSITIOM\"")), {"POSITION"}));
  EXPECT_TRUE(refuses(reading(with(whole, "\"NORMAL\"", "\"NORMAM\"")), {"no normals", "NORMAL"}));
  EXPECT_TRUE(refuses(reading(with(whole, "\"TEXCOORD_0\"", "\"TEXCOORD_9\"")), {"no texture coordinates", "TEXCOORD_0"}));
  EXPECT_TRUE(refuses(reading(with(whole, "\"nodes\":[0]", "\"nodes\":[7]")), {"a.glb"}));
}

TEST(read_glb, refuses_numbers_that_are_none_and_indices_out_of_range) {
  const tb::mesh m = cylinder();
  const std::string whole = tb::glb_bytes(m, "a.glb");
  const std::size_t indices = whole.size() - m.triangles.size() * 12;
  std::string bad = whole;
  bad[indices] = 15;
  EXPECT_TRUE(refuses(reading(bad), {"a.glb", "index out of range", "15 vertices"}));
  bad = whole;
  const float none = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(&bad[whole.find("BIN") + 4], &none, sizeof none);
  EXPECT_TRUE(refuses(reading(bad), {"a.glb", "POSITION", "not finite"}));
}

TEST(read_glb, refuses_a_mirrored_tangent_frame) {
  const tb::mesh m = cylinder();
  std::string bytes = tb::glb_bytes(m, "a.glb");
  const std::size_t first_w = bytes.find("BIN") + 4 + m.vertices.size() * 24 + 12;
  const float mirrored = -1.0f;
  std::memcpy(&bytes[first_w], &mirrored, sizeof mirrored);
  EXPECT_TRUE(refuses(reading(bytes), {"a.glb", "vertex 0", "mirrored"}));
}

}  // namespace
}  // namespace relievo::test
