#include "tb/host/welded.hpp"

#include <cmath>

#include "tb/host/quantise.hpp"
#include "tb/host/value_index.hpp"

namespace relievo::tb {

namespace {

template <class F>
std::int32_t word(double value) {
  const double scaled = std::ldexp(value, F::fraction);
  if (scaled != std::floor(scaled) || std::abs(scaled) > 2147483647.0)
    throw input_error("--raw: the output's values are not words of the formats; a model other than ideal is needed");
  return static_cast<std::int32_t>(scaled);
}

template <class F>
std::array<std::int32_t, 3> words(glm::dvec3 v) {
  return {word<F>(v.x), word<F>(v.y), word<F>(v.z)};
}

raw_vertex raw_words(golden::out_vertex const& v) {
  raw_vertex r;
  r.displaced_p = words<formats::position>(v.displaced_p);
  r.displaced_n = words<formats::unit>(v.displaced_n);
  r.t = words<formats::unit>(v.t);
  r.p = words<formats::position>(v.p);
  r.u = {word<formats::coordinate>(v.u.x), word<formats::coordinate>(v.u.y)};
  return r;
}

std::string comment(scene const& sc) {
  const auto exact = [](double x) {
    std::ostringstream text;
    text.precision(17);
    text << x;
    return text.str();
  };
  return "relievo world_scale " + exact(sc.world_scale) + " centre " + exact(sc.centre.x) + " " + exact(sc.centre.y) + " " +
         exact(sc.centre.z) + " map " + std::to_string(sc.map.width) + " " + std::to_string(sc.map.height) +
         (sc.map.wrap_u ? " wrap" : " clamp") + (sc.map.wrap_v ? " wrap" : " clamp");
}

}  // namespace

mesh welded(std::vector<golden::triangle_out> const& triangles, scene const& sc, bool raw) {
  mesh m;
  m.name = sc.base.name;
  m.has_tangents = true;
  m.comments.push_back(comment(sc));
  m.triangles.reserve(triangles.size());
  m.base_triangle.reserve(triangles.size());
  value_index<14> index(triangles.size());
  for (golden::triangle_out const& t : triangles) {
    if (t.empty) continue;
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      golden::out_vertex const& v = t.v[k];
      corners[k] = index({v.displaced_p.x, v.displaced_p.y, v.displaced_p.z, v.displaced_n.x, v.displaced_n.y, v.displaced_n.z, v.t.x,
                          v.t.y, v.t.z, v.u.x, v.u.y, v.p.x, v.p.y, v.p.z});
      if (corners[k] < m.vertices.size()) continue;
      m.vertices.push_back({sc.to_world(v.displaced_p), v.displaced_n, v.t, sc.from_texels(v.u)});
      m.undisplaced.push_back(sc.to_world(v.p));
      if (raw) m.raw.push_back(raw_words(v));
    }
    m.triangles.push_back(corners);
    m.base_triangle.push_back(static_cast<std::uint32_t>(t.index));
  }
  return m;
}

}  // namespace relievo::tb
