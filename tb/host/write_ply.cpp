// write_ply: the .ply form that write_mesh.hpp describes: binary, little-endian whatever the machine is.
#include <cstring>

#include "tb/host/write_formats.hpp"

namespace relievo::tb {

namespace {

class little_endian {
 public:
  explicit little_endian(std::string& to) : to_(to) {}
  void put(double value) {
    std::uint64_t bits = 0;
    const double one_zero = value + 0.0;
    std::memcpy(&bits, &one_zero, sizeof bits);
    put_bits(bits, 8);
  }
  void put(std::uint32_t value) { put_bits(value, 4); }
  void put(std::int32_t value) { put_bits(static_cast<std::uint32_t>(value), 4); }
  void put_byte(std::uint8_t value) { put_bits(value, 1); }
  void put(glm::dvec3 v) {
    for (int i = 0; i < 3; ++i) put(v[i]);
  }
  template <std::size_t N>
  void put(std::array<std::int32_t, N> const& words) {
    for (std::int32_t w : words) put(w);
  }

 private:
  void put_bits(std::uint64_t bits, int bytes) {
    for (int i = 0; i < bytes; ++i) to_.push_back(static_cast<char>(bits >> (8 * i) & 0xff));
  }
  std::string& to_;
};

void declare(std::string& header, char const* type, std::initializer_list<char const*> names) {
  for (char const* name : names) header += std::string("property ") + type + " " + name + "\n";
}

}  // namespace

std::string ply_bytes(mesh const& m) {
  const bool undisplaced = !m.undisplaced.empty(), raw = !m.raw.empty(), base = !m.base_triangle.empty();
  std::string bytes = "ply\nformat binary_little_endian 1.0\n";
  for (std::string const& comment : m.comments) bytes += "comment " + comment + "\n";
  bytes += "element vertex " + std::to_string(m.vertices.size()) + "\n";
  declare(bytes, "double", {"x", "y", "z", "nx", "ny", "nz"});
  if (m.has_tangents) declare(bytes, "double", {"tx", "ty", "tz"});
  declare(bytes, "double", {"s", "t"});
  if (undisplaced) declare(bytes, "double", {"px", "py", "pz"});
  if (raw) {
    declare(bytes, "int", {"raw_x", "raw_y", "raw_z", "raw_nx", "raw_ny", "raw_nz", "raw_tx", "raw_ty", "raw_tz"});
    declare(bytes, "int", {"raw_s", "raw_t", "raw_px", "raw_py", "raw_pz"});
  }
  bytes += "element face " + std::to_string(m.triangles.size()) + "\nproperty list uchar uint vertex_indices\n";
  if (base) declare(bytes, "uint", {"base_triangle"});
  bytes += "end_header\n";
  bytes.reserve(bytes.size() + m.vertices.size() * 168 + m.triangles.size() * 17);
  little_endian out(bytes);
  for (std::size_t i = 0; i < m.vertices.size(); ++i) {
    base_vertex const& v = m.vertices[i];
    out.put(v.p);
    out.put(v.n);
    if (m.has_tangents) out.put(v.t);
    out.put(v.u.x);
    out.put(v.u.y);
    if (undisplaced) out.put(m.undisplaced[i]);
    if (raw) {
      raw_vertex const& r = m.raw[i];
      out.put(r.displaced_p);
      out.put(r.displaced_n);
      out.put(r.t);
      out.put(r.u);
      out.put(r.p);
    }
  }
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    out.put_byte(3);
    for (std::uint32_t index : m.triangles[i]) out.put(index);
    if (base) out.put(m.base_triangle[i]);
  }
  return bytes;
}

}  // namespace relievo::tb
