// read_obj: .obj by tinyobjloader. The library takes what is no number for 0 and trusts indices, so the statements that matter (v, vt, vn,
// f) are looked through first; the others (materials, groups, lines, smoothing) don't reach it.
#include <tiny_obj_loader.h>

#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "tb/host/input_error.hpp"
#include "tb/host/read_mesh.hpp"

namespace relievo::tb {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

// The next word of a line; empty at its end.
std::string_view next_word(std::string_view& line) {
  std::size_t from = 0;
  while (from < line.size() && is_space(line[from])) ++from;
  std::size_t to = from;
  while (to < line.size() && !is_space(line[to])) ++to;
  const std::string_view word = line.substr(from, to - from);
  line.remove_prefix(to);
  return word;
}

// Goes through the statements and collects those for the library.
class obj_statements {
 public:
  explicit obj_statements(std::string const& name) : name_(name) {}

  void line(std::string_view text) {
    ++number_;
    std::string_view rest = text.substr(0, text.find('#'));
    const std::string_view what = next_word(rest);
    if (what == "v") {
      numbers(what, rest, 3);
      ++count_[0];
    } else if (what == "vt") {
      numbers(what, rest, 2);
      ++count_[1];
    } else if (what == "vn") {
      numbers(what, rest, 3);
      ++count_[2];
    } else if (what == "f") {
      face(rest);
    }
  }

  std::string const& kept() const { return kept_; }
  std::size_t faces() const { return faces_; }
  bool all_have_coordinates() const { return faces_ > 0 && corners_ == with_coordinate_; }
  bool all_have_normals() const { return faces_ > 0 && corners_ == with_normal_; }

  // Once everything is counted: no face may name what the file doesn't hold.
  void check_indices() const {
    for (std::size_t i = 0; i < 3; ++i)
      if (largest_[i].index > count_[i])
        throw input_error(name_ + ": line " + std::to_string(largest_[i].line) + ": face: index " + std::to_string(largest_[i].index) +
                          " is out of range; there are " + std::to_string(count_[i]) + " lines " + label(i));
  }

 private:
  static char const* label(std::size_t i) { return i == 0 ? "v" : i == 1 ? "vt" : "vn"; }

  [[noreturn]] void fail(std::string const& why) const { throw input_error(name_ + ": line " + std::to_string(number_) + ": " + why); }

  // The statement goes on in the words that were checked, so that the library meets nothing else.
  void numbers(std::string_view what, std::string_view rest, int needed) {
    kept_ += what;
    for (int i = 0; i < needed; ++i) {
      const std::string_view word = next_word(rest);
      if (word.empty()) fail(std::string(what) + ": " + std::to_string(needed) + " numbers are needed");
      const std::string_view digits = word.front() == '+' ? word.substr(1) : word;
      double value = 0.0;
      const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
      if (failed != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value) || std::abs(value) > 1e30)
        fail(std::string(what) + ": '" + std::string(word.substr(0, 40)) + "' is not a finite number");
      kept_ += ' ';
      kept_ += digits;
    }
    kept_ += '\n';
  }

  void face(std::string_view rest) {
    kept_ += 'f';
    int corners = 0;
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
      ++corners;
      corner(word);
    }
    if (corners < 3) fail("face: at least 3 corners are needed");
    corners_ += static_cast<std::size_t>(corners);
    ++faces_;
    kept_ += '\n';
  }

  // v, v/vt, v//vn or v/vt/vn; negative numbers count from the latest line back.
  void corner(std::string_view word) {
    const std::string_view whole = word;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t slash = word.find('/');
      const std::string_view digits = word.substr(0, slash);
      if (!digits.empty()) {
        const std::size_t index = resolve(digits, whole, i);
        kept_ += i == 0 ? " " : i == 1 ? "/" : coordinate_given_ ? "/" : "//";
        kept_ += std::to_string(index);
        if (i == 1) ++with_coordinate_;
        if (i == 2) ++with_normal_;
      } else if (i == 0) {
        fail("face: '" + std::string(whole.substr(0, 40)) + "' names no position");
      }
      if (i == 1) coordinate_given_ = !digits.empty();
      if (slash == std::string_view::npos) return;
      word.remove_prefix(slash + 1);
    }
    fail("face: '" + std::string(whole.substr(0, 40)) + "' has more than position/coordinate/normal");
  }

  std::size_t resolve(std::string_view digits, std::string_view whole, std::size_t i) {
    long long index = 0;
    const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (failed != std::errc() || end != digits.data() + digits.size()) fail("face: '" + std::string(whole.substr(0, 40)) + "' is no index");
    if (index < 0) index += static_cast<long long>(count_[i]) + 1;
    if (index <= 0 || index > 0x7fffffff) fail("face: '" + std::string(whole.substr(0, 40)) + "': index out of range");
    const auto used = static_cast<std::size_t>(index);
    if (used > largest_[i].index) largest_[i] = {used, number_};
    return used;
  }

  struct place {
    std::size_t index = 0, line = 0;
  };
  std::string const& name_;
  std::string kept_;
  std::array<std::size_t, 3> count_{};
  std::array<place, 3> largest_{};
  std::size_t number_ = 0, faces_ = 0, corners_ = 0, with_coordinate_ = 0, with_normal_ = 0;
  bool coordinate_given_ = false;
};

obj_statements look_through(std::string_view bytes, std::string const& name) {
  obj_statements statements(name);
  std::string joined;
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    // A backslash at its end continues a line.
    if (!line.empty() && line.back() == '\\' && !bytes.empty()) {
      joined.append(line.substr(0, line.size() - 1)).push_back(' ');
      continue;
    }
    if (joined.empty()) {
      statements.line(line);
    } else {
      joined.append(line);
      statements.line(joined);
      joined.clear();
    }
  }
  statements.check_indices();
  return statements;
}

}  // namespace

loose_mesh read_any_obj(std::string_view bytes, std::string const& name) {
  constexpr std::string_view utf8_mark = "\xef\xbb\xbf";
  if (bytes.substr(0, utf8_mark.size()) == utf8_mark) bytes.remove_prefix(utf8_mark.size());
  if (bytes.find('\0') != std::string_view::npos) throw input_error(name + ": holds a zero byte, so it is no .obj text");
  const obj_statements statements = look_through(bytes, name);
  loose_mesh out;
  out.m.name = name;
  if (statements.faces() == 0) throw input_error(name + ": no faces (f); at least one is needed");
  out.has_coordinates = statements.all_have_coordinates();
  out.has_normals = statements.all_have_normals();

  tinyobj::ObjReader reader;
  tinyobj::ObjReaderConfig config;
  config.triangulate = false;
  config.vertex_color = false;
  if (!reader.ParseFromString(statements.kept(), "", config)) throw input_error(name + ": unusable as .obj: " + reader.Error());
  const tinyobj::attrib_t& attributes = reader.GetAttrib();
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto vertex_of = [&](tinyobj::index_t const& index) {
    const auto [found, added] = numbers.emplace(std::array<int, 3>{index.vertex_index, index.texcoord_index, index.normal_index},
                                                static_cast<std::uint32_t>(out.m.vertices.size()));
    if (added) {
      base_vertex v;
      const auto at = [](int i, std::size_t width, std::size_t k) { return static_cast<std::size_t>(i) * width + k; };
      for (std::size_t k = 0; k < 3; ++k) {
        v.p[static_cast<int>(k)] = attributes.vertices.at(at(index.vertex_index, 3, k));
        if (out.has_normals) v.n[static_cast<int>(k)] = attributes.normals.at(at(index.normal_index, 3, k));
        if (out.has_coordinates && k < 2) v.u[static_cast<int>(k)] = attributes.texcoords.at(at(index.texcoord_index, 2, k));
      }
      out.m.vertices.push_back(v);
    }
    return found->second;
  };
  try {
    for (tinyobj::shape_t const& shape : reader.GetShapes()) {
      std::size_t first = 0;
      for (const unsigned corners : shape.mesh.num_face_vertices) {
        for (std::size_t i = 2; i < corners; ++i)
          out.m.triangles.push_back({vertex_of(shape.mesh.indices.at(first)), vertex_of(shape.mesh.indices.at(first + i - 1)),
                                     vertex_of(shape.mesh.indices.at(first + i))});
        first += corners;
      }
    }
  } catch (std::out_of_range const&) {
    throw input_error(name + ": a face names what the file does not hold");
  }
  return out;
}

}  // namespace relievo::tb
