// read_ply: .ply, text or binary of either byte order, any elements and properties (those without a meaning here are passed over).
// An own reader: tinyply and miniply aren't in Debian, and assimp keeps neither unknown properties (undisplaced position, base triangle,
// raw words) nor doubles.
//
//   vertex   x y z; nx ny nz; tx ty tz; s t (or u v, texture_u texture_v); px py pz; raw_x.. (write_mesh.hpp)
//   face     vertex_indices (or vertex_index): a list; base_triangle
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>

#include "tb/host/input_error.hpp"
#include "tb/host/ply_header.hpp"
#include "tb/host/read_mesh.hpp"

namespace relievo::tb {

namespace {

// What a vertex record can hold, in the order in which `values` keeps it.
enum field { x, y, z, nx, ny, nz, tx, ty, tz, s, t, px, py, pz, first_raw, last_raw = first_raw + 13, fields };

int meaning(std::string const& name) {
  static const std::map<std::string, int> meanings = [] {
    std::map<std::string, int> m = {{"u", s}, {"v", t}, {"texture_u", s}, {"texture_v", t}, {"texture_s", s}, {"texture_t", t}};
    int next = 0;
    for (char const* own : {"x",      "y",      "z",      "nx",    "ny",    "nz",     "tx",     "ty",     "tz",     "s",
                            "t",      "px",     "py",     "pz",    "raw_x", "raw_y",  "raw_z",  "raw_nx", "raw_ny", "raw_nz",
                            "raw_tx", "raw_ty", "raw_tz", "raw_s", "raw_t", "raw_px", "raw_py", "raw_pz"})
      m[own] = next++;
    return m;
  }();
  const auto found = meanings.find(name);
  return found == meanings.end() ? -1 : found->second;
}

template <class T>
double as(std::array<char, 8> const& bytes) {
  T value;
  std::memcpy(&value, bytes.data(), sizeof value);
  return static_cast<double>(value);
}

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

class ply_reader {
 public:
  ply_reader(std::string_view bytes, std::string const& name) : rest_(bytes), name_(name) {}

  loose_mesh read() {
    ply_header header = read_ply_header(rest_, name_);
    encoding_ = header.encoding;
    out_.m.name = name_;
    out_.m.comments = std::move(header.comments);
    for (ply_element const& e : header.elements) {
      element_ = &e;
      check_room();
      if (e.name == "vertex") {
        vertices();
      } else if (e.name == "face") {
        faces();
      } else if (!e.properties.empty()) {
        for (item_ = 0; item_ < e.count; ++item_)
          for (ply_property const& p : e.properties) pass_over(p);
      }
    }
    if (!have_vertices_) fail("header: no element vertex");
    if (!have_faces_) fail("header: no element face");
    for (std::size_t i = 0; i < out_.m.triangles.size(); ++i)
      for (std::uint32_t index : out_.m.triangles[i])
        if (index >= out_.m.vertices.size())
          fail("triangle " + std::to_string(i) + ": index " + std::to_string(index) + " is out of range; there are " +
               std::to_string(out_.m.vertices.size()) + " vertices");
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(std::string const& why) const { throw input_error(name_ + ": " + why); }
  // With the record that is being read.
  [[noreturn]] void fail_here(std::string const& why) const {
    fail(element_->name.substr(0, 40) + " " + std::to_string(item_) + ": " + (property_ ? property_->name.substr(0, 40) + ": " : "") + why);
  }

  // The bytes that the element needs at the least; a count that the file can't hold is refused before anything is made of it.
  void check_room() const {
    std::uint64_t least = 0;
    for (ply_property const& p : element_->properties)
      least += encoding_ == ply_encoding::text ? 2 : p.is_list ? size_of(p.count_type) : size_of(p.type);
    if (least > 0 && element_->count > (rest_.size() + 1) / least)
      fail("element " + element_->name.substr(0, 40) + ": the file ends early, it is too short for " + std::to_string(element_->count) +
           " of them");
  }

  double text_number() {
    std::size_t from = 0;
    while (from < rest_.size() && is_blank(rest_[from])) ++from;
    if (from < rest_.size() && rest_[from] == '+') ++from;
    std::size_t to = from;
    while (to < rest_.size() && !is_blank(rest_[to])) ++to;
    if (from == to) fail_here("the file ends early");
    double value = 0.0;
    const auto [end, failed] = std::from_chars(rest_.data() + from, rest_.data() + to, value);
    if (failed != std::errc() || end != rest_.data() + to)
      fail_here("'" + std::string(rest_.substr(from, std::min<std::size_t>(to - from, 40))) + "' is not a number");
    rest_.remove_prefix(to);
    return value;
  }

  double number(ply_number type) {
    if (encoding_ == ply_encoding::text) return text_number();
    const std::size_t size = size_of(type);
    if (rest_.size() < size) fail_here("the file ends early");
    const std::uint16_t one = 1;
    const bool machine_is_little = *reinterpret_cast<unsigned char const*>(&one) == 1;
    std::array<char, 8> bytes{};
    for (std::size_t i = 0; i < size; ++i) bytes[i] = rest_[(encoding_ == ply_encoding::little) == machine_is_little ? i : size - 1 - i];
    rest_.remove_prefix(size);
    switch (type) {
      case ply_number::i8:
        return as<std::int8_t>(bytes);
      case ply_number::u8:
        return as<std::uint8_t>(bytes);
      case ply_number::i16:
        return as<std::int16_t>(bytes);
      case ply_number::u16:
        return as<std::uint16_t>(bytes);
      case ply_number::i32:
        return as<std::int32_t>(bytes);
      case ply_number::u32:
        return as<std::uint32_t>(bytes);
      case ply_number::f32:
        return as<float>(bytes);
      default:
        return as<double>(bytes);
    }
  }

  std::vector<double> const& list(ply_property const& p) {
    property_ = &p;
    const double count = number(p.count_type);
    const double each = encoding_ == ply_encoding::text ? 2.0 : static_cast<double>(size_of(p.type));
    if (!(count >= 0.0) || count != std::floor(count)) fail_here("the list's length is no whole number from 0");
    if (count * each > static_cast<double>(rest_.size()) + 1.0) fail_here("the file ends early");
    list_.clear();
    for (double k = 0.0; k < count; k += 1.0) list_.push_back(number(p.type));
    return list_;
  }

  double scalar(ply_property const& p) {
    property_ = &p;
    return number(p.type);
  }

  void pass_over(ply_property const& p) {
    if (p.is_list) {
      list(p);
    } else {
      scalar(p);
    }
  }

  std::uint32_t whole(double value) const {
    if (!(value >= 0.0) || value != std::floor(value) || value > 4294967295.0) fail_here("a whole number from 0 is needed");
    return static_cast<std::uint32_t>(value);
  }

  void take_raw_words(std::array<double, fields> const& values) {
    raw_vertex r;
    std::size_t next = first_raw;
    const auto take = [&](auto& words) {
      for (auto& word : words) {
        const double w = values[next++];
        if (w != std::floor(w) || std::abs(w) > 2147483647.0) fail_here("a raw word is no whole number of 32 bits");
        word = static_cast<std::int32_t>(w);
      }
    };
    take(r.displaced_p);
    take(r.displaced_n);
    take(r.t);
    take(r.u);
    take(r.p);
    out_.m.raw.push_back(r);
  }

  void vertices() {
    if (have_vertices_) fail("header: element vertex stands twice");
    have_vertices_ = true;
    std::array<bool, fields> have{};
    std::vector<int> where;
    for (ply_property const& p : element_->properties) {
      where.push_back(p.is_list ? -1 : meaning(p.name));
      if (where.back() < 0) continue;
      bool& known = have[static_cast<std::size_t>(where.back())];
      if (known) fail("header: vertex property " + p.name + " stands twice");
      known = true;
    }
    const auto all = [&](int from, int to) {
      for (int i = from; i <= to; ++i)
        if (!have[static_cast<std::size_t>(i)]) return false;
      return true;
    };
    if (!all(x, z)) fail("header: vertex needs the properties x, y and z");
    out_.has_normals = all(nx, nz);
    out_.has_coordinates = all(s, t);
    out_.m.has_tangents = all(tx, tz);
    const bool undisplaced = all(px, pz), raw = all(first_raw, last_raw);
    std::array<double, fields> values{};
    for (item_ = 0; item_ < element_->count; ++item_) {
      for (std::size_t k = 0; k < where.size(); ++k) {
        if (where[k] < 0) {
          pass_over(element_->properties[k]);
          continue;
        }
        const double value = scalar(element_->properties[k]);
        if (!std::isfinite(value)) fail_here("is not finite");
        values[static_cast<std::size_t>(where[k])] = value;
      }
      base_vertex v;
      v.p = glm::dvec3(values[x], values[y], values[z]);
      if (out_.has_normals) v.n = glm::dvec3(values[nx], values[ny], values[nz]);
      if (out_.m.has_tangents) v.t = glm::dvec3(values[tx], values[ty], values[tz]);
      if (out_.has_coordinates) v.u = glm::dvec2(values[s], values[t]);
      out_.m.vertices.push_back(v);
      if (undisplaced) out_.m.undisplaced.emplace_back(values[px], values[py], values[pz]);
      if (raw) take_raw_words(values);
    }
    property_ = nullptr;
  }

  void faces() {
    if (have_faces_) fail("header: element face stands twice");
    have_faces_ = true;
    const auto is_indices = [](ply_property const& p) { return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index"); };
    const auto is_base = [](ply_property const& p) { return !p.is_list && p.name == "base_triangle"; };
    bool have_indices = false, have_base = false;
    for (ply_property const& p : element_->properties) {
      if (is_indices(p) && have_indices) fail("header: face has two lists of vertex indices");
      have_indices = have_indices || is_indices(p);
      have_base = have_base || is_base(p);
    }
    if (!have_indices) fail("header: face needs the list property vertex_indices");
    std::vector<std::uint32_t> corners;
    for (item_ = 0; item_ < element_->count; ++item_) {
      std::uint32_t base = 0;
      for (ply_property const& p : element_->properties) {
        if (is_indices(p)) {
          corners.clear();
          for (double value : list(p)) corners.push_back(whole(value));
          if (corners.size() < 3) fail_here("at least 3 corners are needed");
        } else if (is_base(p)) {
          base = whole(scalar(p));
        } else {
          pass_over(p);
        }
      }
      for (std::size_t k = 2; k < corners.size(); ++k) {
        out_.m.triangles.push_back({corners[0], corners[k - 1], corners[k]});
        if (have_base) out_.m.base_triangle.push_back(base);
      }
    }
    property_ = nullptr;
  }

  std::string_view rest_;
  std::string const& name_;
  ply_encoding encoding_ = ply_encoding::text;
  ply_element const* element_ = nullptr;
  ply_property const* property_ = nullptr;
  std::uint64_t item_ = 0;
  std::vector<double> list_;
  loose_mesh out_;
  bool have_vertices_ = false, have_faces_ = false;
};

}  // namespace

loose_mesh read_any_ply(std::string_view bytes, std::string const& name) { return ply_reader(bytes, name).read(); }

}  // namespace relievo::tb
