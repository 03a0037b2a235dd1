#include "tb/host/write_mesh.hpp"

#include <charconv>

#include "tb/host/files.hpp"
#include "tb/host/input_error.hpp"
#include "tb/host/welded.hpp"
#include "tb/host/write_formats.hpp"

namespace relievo::tb {

namespace {

void append(std::string& text, char const* word, std::initializer_list<double> values) {
  text += word;
  char digits[40];
  for (double value : values) {
    // The shortest digits that read back as the same double; a negative zero is no other number.
    const auto [end, failed] = std::to_chars(digits, digits + sizeof digits, value + 0.0);
    text += ' ';
    text.append(digits, failed == std::errc() ? end : digits);
  }
  text += '\n';
}

void append_face(std::string& text, std::array<std::uint32_t, 3> const& t) {
  text += 'f';
  for (std::uint32_t i : t) {
    const std::string number = std::to_string(i + 1);
    text += ' ' + number + '/' + number + '/' + number;
  }
  text += '\n';
}

}  // namespace

std::string obj_text(mesh const& m) {
  std::string text = "# " + std::to_string(m.vertices.size()) + " vertices, " + std::to_string(m.triangles.size()) + " triangles\n";
  text.reserve(m.vertices.size() * 160 + m.triangles.size() * 48);
  for (base_vertex const& v : m.vertices) append(text, "v", {v.p.x, v.p.y, v.p.z});
  for (base_vertex const& v : m.vertices) append(text, "vt", {v.u.x, v.u.y});
  for (base_vertex const& v : m.vertices) append(text, "vn", {v.n.x, v.n.y, v.n.z});
  for (auto const& t : m.triangles) append_face(text, t);
  return text;
}

void check_mesh_path(std::string const& path) {
  const std::string extension = extension_of(path);
  if (extension != "obj" && extension != "ply" && extension != "glb")
    throw input_error(path + ": the extension has to be .obj, .ply or .glb");
}

void write_mesh(std::string const& path, std::vector<golden::triangle_out> const& triangles, scene const& sc, bool raw) {
  check_mesh_path(path);
  const std::string extension = extension_of(path);
  if (raw && extension != "ply") throw input_error(path + ": raw words go into .ply files only");
  const mesh m = welded(triangles, sc, raw);
  write_bytes(path, extension == "obj" ? obj_text(m) : extension == "ply" ? ply_bytes(m) : glb_bytes(m, path));
}

void write_base_mesh(std::string const& path, mesh const& m) {
  check_mesh_path(path);
  const std::string extension = extension_of(path);
  write_bytes(path, extension == "obj" ? obj_text(m) : extension == "ply" ? ply_bytes(m) : glb_bytes(m, path));
}

}  // namespace relievo::tb
