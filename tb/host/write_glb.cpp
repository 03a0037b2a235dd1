// write_glb: a mesh as .glb by tinygltf: float attributes in z up under a node that turns them y up, as glTF wants; v from the top.
#include <tiny_gltf.h>

#include <cstring>
#include <limits>
#include <sstream>

#include "tb/host/input_error.hpp"
#include "tb/host/write_formats.hpp"

namespace relievo::tb {

namespace {

class glb_writer {
 public:
  explicit glb_writer(mesh const& m) : m_(m) {}

  std::string bytes() {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = vectors(TINYGLTF_TYPE_VEC3, 3, [](base_vertex const& v, std::size_t, double* to) { put(v.p, to); });
    primitive.attributes["NORMAL"] = vectors(TINYGLTF_TYPE_VEC3, 3, [](base_vertex const& v, std::size_t, double* to) { put(v.n, to); });
    if (m_.has_tangents)
      primitive.attributes["TANGENT"] = vectors(TINYGLTF_TYPE_VEC4, 4, [](base_vertex const& v, std::size_t, double* to) {
        put(v.t, to);
        to[3] = 1.0;
      });
    primitive.attributes["TEXCOORD_0"] = vectors(TINYGLTF_TYPE_VEC2, 2, [](base_vertex const& v, std::size_t, double* to) {
      to[0] = v.u.x;
      to[1] = 1.0 - v.u.y;
    });
    if (!m_.undisplaced.empty())
      primitive.attributes["_UNDISPLACED"] =
          vectors(TINYGLTF_TYPE_VEC3, 3, [this](base_vertex const&, std::size_t i, double* to) { put(m_.undisplaced[i], to); });
    primitive.indices = indices();

    model_.buffers.push_back(buffer_);
    tinygltf::Mesh mesh_entry;
    mesh_entry.primitives.push_back(primitive);
    model_.meshes.push_back(mesh_entry);
    tinygltf::Node node;
    node.mesh = 0;
    // Column by column: x to x, y to -z, z to y.
    node.matrix = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
    model_.nodes.push_back(node);
    tinygltf::Scene scene_entry;
    scene_entry.nodes.push_back(0);
    model_.scenes.push_back(scene_entry);
    model_.defaultScene = 0;
    model_.asset.version = "2.0";
    model_.asset.generator = "relievo";
    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToStream(&model_, stream, false, true)) throw std::runtime_error("tinygltf cannot write this mesh");
    return stream.str();
  }

 private:
  static void put(glm::dvec3 v, double* to) {
    for (int i = 0; i < 3; ++i) to[i] = v[i];
  }

  template <class T>
  void append(T value) {
    unsigned char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    buffer_.data.insert(buffer_.data.end(), raw, raw + sizeof value);
  }

  int finish(int type, int component, int target, std::size_t from, std::size_t count) {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = from;
    view.byteLength = buffer_.data.size() - from;
    view.target = target;
    model_.bufferViews.push_back(view);
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
    accessor.componentType = component;
    accessor.count = count;
    accessor.type = type;
    model_.accessors.push_back(accessor);
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  template <class Fill>
  int vectors(int type, std::size_t width, Fill const& fill) {
    const std::size_t from = buffer_.data.size();
    std::vector<double> low(width, std::numeric_limits<double>::max()), high(width, std::numeric_limits<double>::lowest());
    double values[4] = {0, 0, 0, 0};
    for (std::size_t i = 0; i < m_.vertices.size(); ++i) {
      fill(m_.vertices[i], i, values);
      for (std::size_t k = 0; k < width; ++k) {
        const float value = static_cast<float>(values[k] + 0.0);
        low[k] = std::min(low[k], static_cast<double>(value));
        high[k] = std::max(high[k], static_cast<double>(value));
        append(value);
      }
    }
    const int accessor = finish(type, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TARGET_ARRAY_BUFFER, from, m_.vertices.size());
    model_.accessors.back().minValues = low;
    model_.accessors.back().maxValues = high;
    return accessor;
  }

  int indices() {
    const std::size_t from = buffer_.data.size();
    for (auto const& t : m_.triangles)
      for (std::uint32_t i : t) append(i);
    return finish(TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, from,
                  m_.triangles.size() * 3);
  }

  mesh const& m_;
  tinygltf::Model model_;
  tinygltf::Buffer buffer_;
};

}  // namespace

std::string glb_bytes(mesh const& m, std::string const& name) {
  if (m.triangles.empty()) throw input_error(name + ": a .glb cannot hold a mesh without triangles; .ply or .obj can");
  if (m.vertices.size() * 64 + m.triangles.size() * 12 > 0xf0000000u)
    throw input_error(name + ": the mesh is too large for a .glb of 4 GiB; .ply can hold it");
  return glb_writer(m).bytes();
}

}  // namespace relievo::tb
