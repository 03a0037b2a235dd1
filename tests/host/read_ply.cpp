// read_ply: text and both byte orders give the same mesh; unknown elements and properties are passed over; bad input is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "tb/host/read_mesh.hpp"
#include "tb/host/write_formats.hpp"
#include "tests/support/refuses.hpp"

namespace relievo::test {
namespace {

std::string const header =
    "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n"
    "property float ny\nproperty float nz\nproperty float s\nproperty float t\nelement face 1\nproperty list uchar int vertex_indices\n"
    "end_header\n";
std::string const body = "0 0 0 0 0 1 0 0\n1 0 0 0 0 1 1 0\n1 1 0 0 0 1 1 1\n0 1 0 0 0 1 0 1\n4 0 1 2 3\n";
std::string const quad = header + body;

auto reading(std::string const& bytes) {
  return [bytes] { tb::read_ply(bytes, "a.ply"); };
}

std::string with(std::string text, std::string const& from, std::string const& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

template <class T>
void put(std::string& to, T value, bool big) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  if (big) std::reverse(bytes, bytes + sizeof value);
  to.append(bytes, sizeof value);
}

std::string binary(bool big) {
  std::string bytes = with(header, "ascii", big ? "binary_big_endian" : "binary_little_endian");
  const float vertices[4][8] = {{0, 0, 0, 0, 0, 1, 0, 0}, {1, 0, 0, 0, 0, 1, 1, 0}, {1, 1, 0, 0, 0, 1, 1, 1}, {0, 1, 0, 0, 0, 1, 0, 1}};
  for (auto const& v : vertices)
    for (float x : v) put(bytes, x, big);
  put(bytes, std::uint8_t(4), big);
  for (std::int32_t i : {0, 1, 2, 3}) put(bytes, i, big);
  return bytes;
}

void expect_the_quad(tb::mesh const& m) {
  ASSERT_EQ(m.vertices.size(), 4u);
  EXPECT_EQ(m.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(m.vertices[2].p, glm::dvec3(1, 1, 0));
  EXPECT_EQ(m.vertices[2].n, glm::dvec3(0, 0, 1));
  EXPECT_EQ(m.vertices[3].u, glm::dvec2(0, 1));
  EXPECT_EQ(m.comments, std::vector<std::string>{"by hand"});
}

TEST(read_ply, text_and_both_byte_orders_agree) {
  expect_the_quad(tb::read_ply(quad, "a.ply"));
  expect_the_quad(tb::read_ply(binary(false), "a.ply"));
  expect_the_quad(tb::read_ply(binary(true), "a.ply"));
}

TEST(read_ply, odd_encodings_are_read) {
  // Lines ended by CR LF, another element first, other names, more properties, lists in the vertex.
  std::string text = with(quad, "element vertex", "element camera 2\nproperty list uchar float stuff\nproperty int id\nelement vertex");
  text = with(text, "end_header\n", "end_header\n2 0.5 0.5 7\n0 8\n");
  text = with(with(text, "float s", "float texture_u"), "float t\n", "float texture_v\nproperty uchar red\n");
  for (char const* end : {"0 0 1 0 0\n", "0 0 1 1 0\n", "0 0 1 1 1\n", "0 0 1 0 1\n"})
    text = with(text, end, std::string(end, std::strlen(end) - 1) + " 255\n");
  std::string crlf;
  for (char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_the_quad(tb::read_ply(crlf, "a.ply"));
}

TEST(read_ply, what_we_write_comes_back) {
  tb::mesh m = tb::read_ply(quad, "a.ply");
  m.has_tangents = true;
  for (auto& v : m.vertices) {
    v.t = glm::dvec3(1, 0, 0);
    v.p.z = 1.0 / 3.0;
  }
  m.undisplaced.assign(4, glm::dvec3(0.1, 0.2, 0.3));
  m.base_triangle = {7, 9};
  tb::raw_vertex raw;
  raw.displaced_p = {1, -2, 3};
  raw.u = {1 << 24, 5};
  raw.p = {-8388608, 8388607, 0};
  m.raw.assign(4, raw);
  m.comments = {"relievo world_scale 4"};
  const tb::mesh back = tb::read_ply(tb::ply_bytes(m), "b.ply");
  ASSERT_EQ(back.vertices.size(), 4u);
  EXPECT_TRUE(back.has_tangents);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(back.vertices[i].p, m.vertices[i].p);
    EXPECT_EQ(back.vertices[i].t, m.vertices[i].t);
    EXPECT_EQ(back.vertices[i].u, m.vertices[i].u);
    EXPECT_EQ(back.raw[i].displaced_p, raw.displaced_p);
    EXPECT_EQ(back.raw[i].u, raw.u);
    EXPECT_EQ(back.raw[i].p, raw.p);
  }
  EXPECT_EQ(back.undisplaced, m.undisplaced);
  EXPECT_EQ(back.base_triangle, m.base_triangle);
  EXPECT_EQ(back.comments, m.comments);
}

TEST(read_ply, refuses_every_truncation) {
  for (std::string const& whole : {quad, binary(false), binary(true)}) {
    // The last byte of the text form is a newline that may be missing.
    const std::size_t least = whole.size() - (whole == quad ? 1 : 0);
    for (std::size_t size = 0; size < least; ++size) EXPECT_TRUE(refuses(reading(whole.substr(0, size)), {"a.ply"})) << size;
  }
}

TEST(read_ply, refuses_wrong_headers) {
  EXPECT_TRUE(refuses(reading(with(quad, "ply", "plx")), {"a.ply", "header", "'ply'"}));
  EXPECT_TRUE(refuses(reading(with(quad, "ascii", "utf8")), {"format", "utf8"}));
  EXPECT_TRUE(refuses(reading(with(quad, "format ascii 1.0\n", "")), {"format"}));
  EXPECT_TRUE(refuses(reading(with(quad, "vertex 4", "vertex four")), {"vertex", "four"}));
  EXPECT_TRUE(refuses(reading(with(quad, "vertex 4", "vertex 4000000000")), {"vertex", "too short"}));
  EXPECT_TRUE(refuses(reading(with(quad, "vertex 4", "vertex -1")), {"vertex"}));
  EXPECT_TRUE(refuses(reading(with(quad, "float x", "flaot x")), {"flaot"}));
  EXPECT_TRUE(refuses(reading(with(quad, "property float z\n", "")), {"x, y and z"}));
  EXPECT_TRUE(refuses(reading(with(quad, "float nx", "float x")), {"twice"}));
  EXPECT_TRUE(refuses(reading(with(quad, "vertex_indices", "corners")), {"vertex_indices"}));
  EXPECT_TRUE(refuses(reading(with(quad, "float nx", "float q")), {"no normals", "nx ny nz"}));
  EXPECT_TRUE(refuses(reading(with(quad, "float s", "float q")), {"no texture coordinates", "s t"}));
}

TEST(read_ply, refuses_wrong_numbers) {
  EXPECT_TRUE(refuses(reading(with(quad, "1 1 0 0 0 1", "1 nan 0 0 0 1")), {"a.ply", "vertex 2", "y", "finite"}));
  EXPECT_TRUE(refuses(reading(with(quad, "1 1 0 0 0 1", "1 1e300 0 0 0 1")), {"vertex 2", "position"}));
  EXPECT_TRUE(refuses(reading(with(quad, "1 1 0 0 0 1", "1 1e999 0 0 0 1")), {"vertex 2", "not a number"}));
  EXPECT_TRUE(refuses(reading(with(quad, "1 1 0 0 0 1", "1 x 0 0 0 1")), {"vertex 2", "not a number"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4 0 1 2 3", "4 0 1 2 4")), {"index 4", "out of range", "4 vertices"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4 0 1 2 3", "4 0 1 2 -1")), {"face 0", "whole number"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4 0 1 2 3", "4 0 1 2 1.5")), {"face 0", "whole number"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4 0 1 2 3", "2 0 1")), {"face 0", "3 corners"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4 0 1 2 3", "-4 0 1 2 3")), {"face 0", "length"}));
  EXPECT_TRUE(refuses(reading(with(quad, "4 0 1 2 3", "3 0 1 1")), {"triangle 0", "degenerate"}));
  EXPECT_TRUE(refuses(reading(with(quad, "element face 1", "element face 0")), {"no triangles"}));
}

}  // namespace
}  // namespace relievo::test
