// read_glb: .glb by tinygltf. Pictures and other files that it may name are left alone. The library checks the container; accessors are
// checked here before anything is read through them.
#include <tiny_gltf.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "tb/host/input_error.hpp"
#include "tb/host/read_mesh.hpp"

namespace relievo::tb {

namespace {

template <class T>
double as(unsigned char const* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

class glb_reader {
 public:
  glb_reader(tinygltf::Model const& model, std::string const& name) : model_(model), name_(name), seen_(model.nodes.size(), false) {
    out_.m.name = name;
    out_.has_normals = out_.has_coordinates = true;
    out_.m.has_tangents = true;
  }

  loose_mesh read() {
    for (std::string const& extension : model_.extensionsRequired)
      fail("the extension " + extension + " is needed to read it; export it without");
    for (int root : roots()) node(root, glm::dmat4(1.0), 0);
    if (out_.m.triangles.empty()) fail("no triangles in its scene");
    if (!all_undisplaced_) out_.m.undisplaced.clear();
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(std::string const& why) const { throw input_error(name_ + ": " + why); }

  std::vector<int> roots() const {
    const int scene = model_.defaultScene >= 0 ? model_.defaultScene : 0;
    if (static_cast<std::size_t>(scene) < model_.scenes.size()) return model_.scenes[static_cast<std::size_t>(scene)].nodes;
    std::vector<bool> child(model_.nodes.size(), false);
    for (auto const& n : model_.nodes)
      for (int c : n.children)
        if (c >= 0 && static_cast<std::size_t>(c) < child.size()) child[static_cast<std::size_t>(c)] = true;
    std::vector<int> found;
    for (std::size_t i = 0; i < child.size(); ++i)
      if (!child[i]) found.push_back(static_cast<int>(i));
    return found;
  }

  glm::dmat4 local(tinygltf::Node const& n) const {
    for (auto const* values : {&n.matrix, &n.translation, &n.rotation, &n.scale})
      for (double value : *values)
        if (!std::isfinite(value)) fail("a node's transform is not finite");
    if (n.matrix.size() == 16) return glm::make_mat4(n.matrix.data());
    glm::dmat4 m(1.0);
    if (n.translation.size() == 3) m[3] = glm::dvec4(n.translation[0], n.translation[1], n.translation[2], 1.0);
    if (n.rotation.size() == 4) m *= glm::mat4_cast(glm::dquat(n.rotation[3], n.rotation[0], n.rotation[1], n.rotation[2]));
    if (n.scale.size() == 3)
      for (int i = 0; i < 3; ++i) m[i] *= n.scale[static_cast<std::size_t>(i)];
    return m;
  }

  void node(int index, glm::dmat4 const& parent, int depth) {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size()) fail("nodes: index out of range");
    if (seen_[static_cast<std::size_t>(index)] || depth > 1000) fail("nodes: not a tree");
    seen_[static_cast<std::size_t>(index)] = true;
    tinygltf::Node const& n = model_.nodes[static_cast<std::size_t>(index)];
    const glm::dmat4 world = parent * local(n);
    if (n.mesh >= 0) {
      if (static_cast<std::size_t>(n.mesh) >= model_.meshes.size()) fail("nodes: mesh out of range");
      for (tinygltf::Primitive const& p : model_.meshes[static_cast<std::size_t>(n.mesh)].primitives) primitive(p, world);
    }
    for (int child : n.children) node(child, world, depth + 1);
  }

  // The numbers of an accessor, `width` for each of its entries; normalised integers become 0..1 or -1..1.
  std::vector<double> numbers(int index, int width, std::string const& what) const {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.accessors.size()) fail(what + ": accessor out of range");
    tinygltf::Accessor const& a = model_.accessors[static_cast<std::size_t>(index)];
    if (a.sparse.isSparse || a.bufferView < 0) fail(what + ": sparse accessors are not supported; export it without");
    if (static_cast<std::size_t>(a.bufferView) >= model_.bufferViews.size()) fail(what + ": bufferView out of range");
    tinygltf::BufferView const& view = model_.bufferViews[static_cast<std::size_t>(a.bufferView)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model_.buffers.size()) fail(what + ": buffer out of range");
    auto const& data = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(a.componentType));
    const int given = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(a.type));
    if (size <= 0 || given != width) fail(what + ": has the wrong type");
    const std::size_t entry = static_cast<std::size_t>(size) * static_cast<std::size_t>(width);
    const std::size_t stride = view.byteStride != 0 ? view.byteStride : entry;
    constexpr std::size_t most = std::size_t(1) << 32;
    if (a.count == 0) fail(what + ": is empty");
    if (a.count > most || stride > most || view.byteOffset > most || a.byteOffset > most || view.byteLength > most || stride < entry ||
        a.byteOffset + stride * (a.count - 1) + entry > view.byteLength || view.byteOffset + view.byteLength > data.size())
      fail(what + ": reaches beyond its buffer");
    std::vector<double> out;
    out.reserve(a.count * static_cast<std::size_t>(width));
    for (std::size_t i = 0; i < a.count; ++i) {
      unsigned char const* at = data.data() + view.byteOffset + a.byteOffset + stride * i;
      for (int k = 0; k < width; ++k) out.push_back(component(a, at + k * size, what));
    }
    return out;
  }

  double component(tinygltf::Accessor const& a, unsigned char const* at, std::string const& what) const {
    switch (a.componentType) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return a.normalized ? std::fmax(as<std::int8_t>(at) / 127.0, -1.0) : as<std::int8_t>(at);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return as<std::uint8_t>(at) / (a.normalized ? 255.0 : 1.0);
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return a.normalized ? std::fmax(as<std::int16_t>(at) / 32767.0, -1.0) : as<std::int16_t>(at);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return as<std::uint16_t>(at) / (a.normalized ? 65535.0 : 1.0);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return as<std::uint32_t>(at);
      case TINYGLTF_COMPONENT_TYPE_FLOAT: {
        const double value = as<float>(at);
        if (!std::isfinite(value)) fail(what + ": holds a number that is not finite");
        return value;
      }
      default:
        fail(what + ": has the wrong type");
    }
  }

  std::vector<double> attribute(tinygltf::Primitive const& p, std::string const& what, int width, std::size_t count) const {
    const auto found = p.attributes.find(what);
    if (found == p.attributes.end()) return {};
    std::vector<double> values = numbers(found->second, width, what);
    if (count != 0 && values.size() != count * static_cast<std::size_t>(width)) fail(what + ": has not as many entries as POSITION");
    return values;
  }

  void primitive(tinygltf::Primitive const& p, glm::dmat4 const& world) {
    if (p.mode != -1 && p.mode != TINYGLTF_MODE_TRIANGLES) fail("a primitive is not of triangles (mode 4)");
    const std::vector<double> positions = attribute(p, "POSITION", 3, 0);
    if (positions.empty()) fail("a primitive without POSITION");
    const std::size_t count = positions.size() / 3;
    const std::vector<double> normals = attribute(p, "NORMAL", 3, count), tangents = attribute(p, "TANGENT", 4, count);
    const std::vector<double> coordinates = attribute(p, "TEXCOORD_0", 2, count), undisplaced = attribute(p, "_UNDISPLACED", 3, count);
    out_.has_normals = out_.has_normals && !normals.empty();
    out_.has_coordinates = out_.has_coordinates && !coordinates.empty();
    out_.m.has_tangents = out_.m.has_tangents && !tangents.empty();
    all_undisplaced_ = all_undisplaced_ && !undisplaced.empty();

    const glm::dmat3 linear(world);
    const double turn = glm::determinant(linear);
    if (!(std::abs(turn) > 0.0)) fail("a node's transform is singular");
    const glm::dmat3 for_normals = glm::transpose(glm::inverse(linear));
    const auto z_up = [](glm::dvec3 v) { return glm::dvec3(v.x, -v.z, v.y); };
    const auto first = static_cast<std::uint32_t>(out_.m.vertices.size());
    for (std::size_t i = 0; i < count; ++i) {
      const auto vector = [&](std::vector<double> const& from, std::size_t width) {
        return glm::dvec3(from[i * width], from[i * width + 1], from[i * width + 2]);
      };
      base_vertex v;
      v.p = z_up(glm::dvec3(world * glm::dvec4(vector(positions, 3), 1.0)));
      if (!normals.empty()) v.n = z_up(for_normals * vector(normals, 3));
      if (!tangents.empty()) {
        if (tangents[i * 4 + 3] < 0.0)
          fail("vertex " + std::to_string(i) +
               ": TANGENT has w = -1, so its texture coordinates are mirrored; u to the right and v up are needed");
        v.t = z_up(linear * vector(tangents, 4));
      }
      if (!coordinates.empty()) v.u = glm::dvec2(coordinates[i * 2], 1.0 - coordinates[i * 2 + 1]);
      out_.m.vertices.push_back(v);
      if (!undisplaced.empty()) out_.m.undisplaced.push_back(z_up(glm::dvec3(world * glm::dvec4(vector(undisplaced, 3), 1.0))));
    }
    add_triangles(p, first, count, turn < 0.0);
  }

  void add_triangles(tinygltf::Primitive const& p, std::uint32_t first, std::size_t count, bool turned_over) {
    std::vector<double> corners;
    if (p.indices >= 0) {
      corners = numbers(p.indices, 1, "indices");
    } else {
      for (std::size_t i = 0; i < count; ++i) corners.push_back(static_cast<double>(i));
    }
    if (corners.size() % 3 != 0) fail("indices: not a multiple of three");
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      std::array<std::uint32_t, 3> t{};
      for (std::size_t k = 0; k < 3; ++k) {
        const double index = corners[turned_over ? i + 2 - k : i + k];
        if (!(index >= 0.0) || index >= static_cast<double>(count) || index != std::floor(index))
          fail("triangle " + std::to_string(i / 3) + ": index out of range; there are " + std::to_string(count) + " vertices");
        t[k] = first + static_cast<std::uint32_t>(index);
      }
      out_.m.triangles.push_back(t);
    }
  }

  tinygltf::Model const& model_;
  std::string const& name_;
  std::vector<bool> seen_;
  bool all_undisplaced_ = true;
  loose_mesh out_;
};

}  // namespace

loose_mesh read_any_glb(std::string_view bytes, std::string const& name) {
  if (bytes.size() < 20 || bytes.substr(0, 4) != "glTF") throw input_error(name + ": no .glb file, it has to begin with 'glTF'");
  std::uint32_t version = 0;  // the lowest byte first, whatever the machine's order
  for (std::size_t i = 0; i < 4; ++i) version |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[4 + i])) << (8 * i);
  if (version != 2) throw input_error(name + ": is glTF of version " + std::to_string(version) + "; version 2 is needed");
  if (bytes.size() > 0xffffffffu) throw input_error(name + ": the file is larger than 4 GiB");
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(
      [](tinygltf::Image*, const int, std::string*, std::string*, int, int, unsigned char const*, int, void*) { return true; }, nullptr);
  tinygltf::FsCallbacks no_files{};
  no_files.FileExists = [](std::string const&, void*) { return false; };
  no_files.ExpandFilePath = [](std::string const& path, void*) { return path; };
  no_files.ReadWholeFile = [](std::vector<unsigned char>*, std::string* err, std::string const&, void*) {
    if (err) *err = "other files are not read";
    return false;
  };
  no_files.WriteWholeFile = [](std::string*, std::string const&, std::vector<unsigned char> const&, void*) { return false; };
  loader.SetFsCallbacks(no_files);
  tinygltf::Model model;
  std::string error, warning;
  bool loaded = false;
  try {
    loaded = loader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<unsigned char const*>(bytes.data()),
                                         static_cast<unsigned int>(bytes.size()));
  } catch (std::exception const& e) {
    error = e.what();
  }
  if (!loaded) {
    for (char& c : error)
      if (c == '\n' || c == '\r') c = ' ';
    throw input_error(name + ": unusable as .glb: " + error.substr(0, 200));
  }
  return glb_reader(model, name).read();
}

}  // namespace relievo::tb
