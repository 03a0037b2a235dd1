// check_file and check_output: bring a mesh to the form that the checks take.
#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "hls/core/formats.hpp"
#include "tb/analysis/base_locator.hpp"
#include "tb/analysis/check.hpp"
#include "tb/analysis/check_exact.hpp"
#include "tb/analysis/check_words.hpp"
#include "tb/host/input_error.hpp"

namespace relievo::tb {
namespace {

const double position_word = std::ldexp(1.0, -formats::position::fraction);
const double coordinate_word = std::ldexp(1.0, -formats::coordinate::fraction);

// What a file's U and P are worth: texels that u, v = 0..1 span, wraps, and the words' size.
struct file_scale {
  golden::map_regs map{1.0, 1.0, true, true};
  glm::dvec2 texels{1.0};
  double position_lsb = 0.0;
  double coordinate_lsb = coordinate_word;
};

glm::dvec2 spans(golden::map_regs const& map) {
  return {map.wrap_u ? map.width : map.width - 1.0, map.wrap_v ? map.height : map.height - 1.0};
}

// The comment that write_mesh leaves in a .ply.
std::optional<file_scale> from_comment(mesh const& m) {
  for (auto const& comment : m.comments) {
    std::istringstream words(comment);
    std::string relievo, scale_word, centre_word, map_word, u, v;
    double scale = 0.0;
    glm::dvec3 centre;
    file_scale s;
    words >> relievo >> scale_word >> scale >> centre_word >> centre.x >> centre.y >> centre.z >> map_word >> s.map.width >> s.map.height >>
        u >> v;
    if (!words || relievo != "relievo" || scale_word != "world_scale" || map_word != "map" || !(scale > 0.0)) continue;
    s.map.wrap_u = u == "wrap";
    s.map.wrap_v = v == "wrap";
    s.texels = spans(s.map);
    s.position_lsb = position_word / scale;
    return s;
  }
  return std::nullopt;
}

// Nothing known: U stays 0..1, either axis may wrap; words as those of a map of 256 texels and of a mesh that fills the range.
file_scale guessed(mesh const& m) {
  file_scale s;
  s.coordinate_lsb = coordinate_word / 256.0;
  double extent = 0.0;
  for (auto const& v : m.vertices) extent = std::max({extent, std::abs(v.p.x), std::abs(v.p.y), std::abs(v.p.z)});
  s.position_lsb = extent * std::ldexp(1.0, -22);
  return s;
}

words_mesh words_of(loose_mesh const& file, file_scale const& s) {
  mesh const& f = file.m;
  words_mesh m;
  m.map = s.map;
  m.position_lsb = s.position_lsb;
  m.coordinate_lsb = s.coordinate_lsb;
  m.has_p = f.undisplaced.size() == f.vertices.size();
  m.has_t = f.has_tangents;
  m.has_u = file.has_coordinates;
  m.has_n = file.has_normals;
  m.triangles = f.triangles;
  m.base_triangle = f.base_triangle;
  m.vertices.reserve(f.vertices.size());
  for (std::size_t i = 0; i < f.vertices.size(); ++i) {
    base_vertex const& v = f.vertices[i];
    m.vertices.push_back({m.has_p ? f.undisplaced[i] : glm::dvec3(0.0), v.t, v.u * s.texels, v.p, v.n});
  }
  return m;
}

// Faces that don't name their base triangle get the one that holds their middle in the map. False when that can't be told.
bool locate(words_mesh& m, std::vector<golden::triangle> const& base, check_report& report) {
  if (m.base_triangle.size() == m.triangles.size()) return true;
  if (!m.has_u) {
    report.warnings.push_back("the mesh has no texture coordinates, so its base mesh can't be used: topology only");
    return false;
  }
  for (auto const& t : base) {
    const glm::dvec2 e1 = t.v[1].u - t.v[0].u;
    const glm::dvec2 e2 = t.v[2].u - t.v[0].u;
    if (e1.x * e2.y != e1.y * e2.x) continue;
    report.warnings.push_back(
        "base triangles have no area in the map, so faces that don't name theirs (.ply does) can't be located: topology only");
    return false;
  }
  const base_locator locator(base);
  std::vector<std::uint32_t> found;
  found.reserve(m.triangles.size());
  for (auto const& t : m.triangles) {
    std::uint32_t index = 0xffffffffu;
    if (locator.find((m.vertices[t[0]].u + m.vertices[t[1]].u + m.vertices[t[2]].u) / 3.0, index) == base_locator::answer::several) {
      report.warnings.push_back(
          "base triangles share the map, so faces that don't name theirs (.ply does) can't be told apart: topology only");
      return false;
    }
    found.push_back(index);
  }
  m.base_triangle = std::move(found);
  return true;
}

check_report check_with_base(loose_mesh const& file, file_scale const& s, std::vector<golden::triangle> const& base,
                             check_options const& options) {
  check_report report;
  report.warnings = base_warnings(base);
  words_mesh m = words_of(file, s);
  if (locate(m, base, report)) {
    check_words(m, base, options, report);
  } else {
    check_words(m, {}, options, report);
  }
  return report;
}

}  // namespace

check_report check_output(std::vector<golden::triangle_out> const& out, std::vector<golden::triangle> const& base,
                          golden::map_regs const& map, check_options const& options) {
  check_report report;
  report.warnings = base_warnings(base);
  if (has_weights(out)) {
    check_exact(out, base, map, options, report);
  } else {
    check_words(words_of(out, map), base, options, report);
  }
  return report;
}

check_report check_file(loose_mesh const& file) {
  check_report report;
  if (file.has_normals && file.m.undisplaced.empty()) report.warnings = base_warnings(file.m);
  check_words(words_of(file, from_comment(file.m).value_or(guessed(file.m))), {}, {}, report);
  return report;
}

check_report check_file(loose_mesh const& file, scene const& made_from, check_options const& options) {
  file_scale s;
  s.map = made_from.regs.map;
  s.texels = made_from.texels_per_unit();
  s.position_lsb = position_word / made_from.world_scale;
  std::vector<golden::triangle> base = made_from.triangles;
  for (auto& t : base) {
    for (auto& v : t.v) v.p = made_from.to_world(v.p);
  }
  return check_with_base(file, s, base, options);
}

check_report check_file(loose_mesh const& file, mesh const& base, check_options const& options) {
  const file_scale s = from_comment(file.m).value_or(guessed(file.m));
  std::vector<golden::triangle> triangles;
  triangles.reserve(base.triangles.size());
  for (auto const& t : base.triangles) {
    golden::triangle b;
    for (std::size_t k = 0; k < 3; ++k) {
      base_vertex const& v = base.vertices[t[k]];
      b.v[k].p = v.p;
      b.v[k].n = v.n;
      b.v[k].t = v.t;
      b.v[k].u = v.u * s.texels;
    }
    triangles.push_back(b);
  }
  return check_with_base(file, s, triangles, options);
}

}  // namespace relievo::tb
