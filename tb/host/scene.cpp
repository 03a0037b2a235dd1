#include "tb/host/scene.hpp"

#include <algorithm>
#include <cmath>

#include "tb/host/base_meshes.hpp"
#include "tb/host/quantise.hpp"
#include "tb/host/read_mesh.hpp"
#include "tb/host/scene_registers.hpp"
#include "tb/host/sweep_registers.hpp"
#include "tb/host/value_index.hpp"

namespace relievo::tb {

namespace {

// 15/16 of what positions, heights and the scale over all samples can hold.
constexpr double limit = 7.5;

// The heights that the map's samples reach, in world units.
struct heights {
  double low = 0.0, high = 0.0;
  double largest() const { return std::fmax(std::abs(low), std::abs(high)); }
};

heights heights_of(scene const& sc, map_extremes const& e) {
  const double a = sc.options.bias + sc.world_per_sample() * e.min, b = sc.options.bias + sc.world_per_sample() * e.max;
  return {std::fmin(a, b), std::fmax(a, b)};
}

struct box {
  glm::dvec3 low, high;
};

// The mesh, grown by the displacement: in every direction, but along its normal for a plane.
box displaced_box(mesh const& m, double height) {
  box b{m.vertices.front().p, m.vertices.front().p};
  for (base_vertex const& v : m.vertices) {
    b.low = glm::min(b.low, v.p);
    b.high = glm::max(b.high, v.p);
  }
  const glm::dvec3 grow = m.planar ? glm::abs(m.vertices.front().n) * height : glm::dvec3(height);
  return {b.low - grow, b.high + grow};
}

double half_size(box const& b, glm::dvec3 centre) {
  const glm::dvec3 size = glm::max(glm::abs(b.low - centre), glm::abs(b.high - centre));
  return std::max({size.x, size.y, size.z});
}

// The largest power of two that brings `size` to at most `limit`; 1 for a size of 0.
double power_below(double size) {
  if (!(size > 0.0)) return 1.0;
  int exponent = 0;
  std::frexp(limit / size, &exponent);
  return std::ldexp(1.0, std::clamp(exponent - 1, -60, 60));
}

void choose_units(scene& sc, box const& b) {
  // bias and scale have registers of their own, whatever the map makes of them.
  const double others = std::fmax(std::abs(sc.options.bias), std::abs(sc.options.scale));
  const double as_it_is = power_below(std::fmax(half_size(b, glm::dvec3(0.0)), others));
  const glm::dvec3 middle = 0.5 * (b.low + b.high);
  const double centred = power_below(std::fmax(half_size(b, middle), others));
  sc.world_scale = as_it_is;
  if (centred < 4.0 * as_it_is) return;
  // On whole engine units, so that it is exact there.
  sc.centre = glm::round(middle * centred) / centred;
  sc.world_scale = power_below(std::fmax(half_size(b, sc.centre), others));
}

double texel_coordinate(scene const& sc, std::size_t i, int axis) {
  const double u = sc.base.vertices[i].u[axis];
  const double most = sc.texels_per_unit()[axis];
  const double texels = round_half_up<formats::coordinate>(u * most);
  if (!(u >= -1e-3 && u <= 1.0 + 1e-3) || texels < 0.0 || texels > most)
    throw input_error(sc.base.name + ": vertex " + std::to_string(i) + ": texture coordinate " + (axis == 0 ? "u" : "v") + " = " +
                      shown(u) + " lies outside the map; from 0 to 1 is needed");
  return texels;
}

template <class F>
glm::dvec3 rounded(glm::dvec3 v) {
  return {round_half_up<F>(v.x), round_half_up<F>(v.y), round_half_up<F>(v.z)};
}

// P, N and U of every vertex in the formats.
std::vector<golden::vertex> quantised_vertices(scene const& sc) {
  std::vector<golden::vertex> out(sc.base.vertices.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    base_vertex const& v = sc.base.vertices[i];
    out[i].p = rounded<formats::position>(sc.from_world(v.p));
    out[i].n = rounded<formats::unit>(v.n);
    out[i].u = {texel_coordinate(sc, i, 0), texel_coordinate(sc, i, 1)};
  }
  return out;
}

// Which vertices agree in P, N and U (modulo the wrap), as the engine sees them.
std::vector<std::uint32_t> classes_of(scene const& sc, std::vector<golden::vertex> const& vertices) {
  value_index<8> index(vertices.size());
  std::vector<std::uint32_t> numbers;
  numbers.reserve(vertices.size());
  for (golden::vertex const& v : vertices) {
    const double u = sc.map.wrap_u && v.u.x == sc.map.width ? 0.0 : v.u.x;
    const double w = sc.map.wrap_v && v.u.y == sc.map.height ? 0.0 : v.u.y;
    numbers.push_back(index({v.p.x, v.p.y, v.p.z, v.n.x, v.n.y, v.n.z, u, w}));
  }
  return numbers;
}

// The papers leave it to whoever makes the mesh that a surface without a gap has one normal at a point.
void warn_of_split_normals(scene& sc, std::vector<golden::vertex> const& vertices) {
  value_index<3> index(vertices.size());
  std::vector<glm::dvec3> first;
  std::vector<bool> split;
  for (golden::vertex const& v : vertices) {
    const std::uint32_t place = index({v.p.x, v.p.y, v.p.z});
    if (place == first.size()) {
      first.push_back(v.n);
      split.push_back(false);
    } else if (v.n != first[place]) {
      split[place] = true;
    }
  }
  const auto count = std::count(split.begin(), split.end(), true);
  if (count > 0)
    sc.warnings.push_back(sc.base.name + ": at " + std::to_string(count) +
                          " positions vertices share the position but not the normal; the displaced surface will part there");
}

void make_triangles(scene& sc, std::vector<golden::vertex> const& vertices) {
  sc.triangles.reserve(sc.base.triangles.size());
  for (auto const& corners : sc.base.triangles) {
    golden::triangle t;
    for (std::size_t k = 0; k < 3; ++k) t.v[k] = vertices[corners[k]];
    t.index = static_cast<double>(sc.triangles.size());
    sc.triangles.push_back(t);
  }
  sc.triangles.back().last = true;
}

// What there is to be seen: the mesh at the lowest and at the highest displacement.
box seen_box(mesh const& m, heights const& h) {
  box b{glm::dvec3(INFINITY), glm::dvec3(-INFINITY)};
  for (base_vertex const& v : m.vertices) {
    for (double height : {h.low, h.high}) {
      b.low = glm::min(b.low, v.p + v.n * height);
      b.high = glm::max(b.high, v.p + v.n * height);
    }
  }
  return b;
}

void set_camera(scene& sc, heights const& h) {
  scene_options& o = sc.options;
  const box b = seen_box(sc.base, h);
  const glm::dvec3 middle = 0.5 * (b.low + b.high);
  const double radius = std::fmax(0.5 * glm::length(b.high - b.low), 1e-9);
  camera_view view;
  view.up = o.up;
  view.fov_degrees = o.fov_degrees;
  view.width = o.viewport[0];
  view.height = o.viewport[1];
  view.at = o.at.value_or(middle);
  view.eye = o.eye ? *o.eye : view.at + (look_at_box(view, b.low, b.high).eye - middle);
  const double distance = glm::length(view.eye - middle);
  view.near = o.near.value_or(std::fmax(distance - 2.0 * radius, 0.01 * radius));
  view.far = o.far.value_or(std::fmax(distance + 2.0 * radius, 2.0 * view.near));
  o.eye = view.eye;
  o.at = view.at;
  o.near = view.near;
  o.far = view.far;
  sc.camera = view;

  const double reach = -min_of<formats::eye>() / sc.world_scale;
  const glm::dvec3 off = glm::abs(view.eye - sc.centre);
  if (!(off.x < reach && off.y < reach && off.z < reach))
    throw input_error("--eye: " + shown(view.eye.x) + "," + shown(view.eye.y) + "," + shown(view.eye.z) +
                      " is too far from a mesh of this size; up to " + shown(reach) + " from " + shown(sc.centre.x) + "," +
                      shown(sc.centre.y) + "," + shown(sc.centre.z) + " along each axis is possible");
  camera_view engine = view;
  engine.eye = sc.from_world(view.eye);
  engine.at = sc.from_world(view.at);
  engine.near = view.near * sc.world_scale;
  engine.far = view.far * sc.world_scale;
  const camera_registers registers = make_camera_registers(engine);
  sc.regs.transform = registers.transform;
  sc.regs.transform_normal = registers.transform_normal;
  sc.row_exponent = registers.row_exponent;
}

std::array<bool, 2> addresses(scene_options const& o) { return o.wrap.value_or(std::array<bool, 2>{wraps_in_u(o.mesh), false}); }

}  // namespace

glm::dvec2 scene::texels_per_unit() const { return {map.wrap_u ? map.width : map.width - 1, map.wrap_v ? map.height : map.height - 1}; }

glm::dvec2 scene::from_texels(glm::dvec2 texels) const {
  const glm::dvec2 per_unit = texels_per_unit();
  return {per_unit.x > 0.0 ? texels.x / per_unit.x : 0.0, per_unit.y > 0.0 ? texels.y / per_unit.y : 0.0};
}

double scene::physical_per_sample() const { return map.range ? std::abs(map.range->high - map.range->low) / 65535.0 : 1.0; }

double scene::physical(double sample) const {
  return map.range ? map.range->low + (map.range->high - map.range->low) * sample / 65535.0 : sample;
}

scene make_scene(scene_options const& options) {
  displacement_map map = load_map(options.displacement, options.sample_range);
  const std::array<bool, 2> wrap = addresses(options);
  const glm::dvec2 samples(wrap[0] ? map.width : std::max(1, map.width - 1), wrap[1] ? map.height : std::max(1, map.height - 1));
  std::optional<mesh> base = make_base_mesh(options.mesh, samples);
  if (!base) base = read_mesh(options.mesh);
  return make_scene(options, std::move(*base), std::move(map));
}

scene make_scene(scene_options const& options, mesh base, displacement_map map) {
  for (double value : {options.scale, options.bias})
    if (!std::isfinite(value) || std::abs(value) > 1e9) throw input_error("--scale, --bias: finite numbers up to 1e9 are needed");
  scene sc;
  sc.options = options;
  sc.base = std::move(base);
  sc.map = std::move(map);
  check_base_mesh(sc.base);
  sc.options.wrap = addresses(options);
  sc.map.wrap_u = (*sc.options.wrap)[0];
  sc.map.wrap_v = (*sc.options.wrap)[1];
  if (options.sample_range) sc.map.range = options.sample_range;
  if (sc.map.range && !(std::isfinite(sc.physical_per_sample()) && sc.physical_per_sample() > 0.0))
    throw input_error("--sample-range: two different finite numbers are needed");
  sc.base.planar = is_planar(sc.base);
  sc.regs.map.width = sc.map.width;
  sc.regs.map.height = sc.map.height;
  sc.regs.map.wrap_u = sc.map.wrap_u;
  sc.regs.map.wrap_v = sc.map.wrap_v;

  const map_extremes extremes = measure(sc.map);
  const heights h = heights_of(sc, extremes);
  choose_units(sc, displaced_box(sc.base, h.largest()));
  set_displacement(sc);

  std::vector<golden::vertex> vertices = quantised_vertices(sc);
  complete_tangents(sc.base, classes_of(sc, vertices));
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i].t = rounded<formats::unit>(sc.base.vertices[i].t);
  warn_of_split_normals(sc, vertices);
  make_triangles(sc, vertices);

  set_normal_map(sc, extremes);
  set_camera(sc, h);
  set_tests(sc, extremes);
  if (options.engine == engine_kind::sweep) set_sweep(sc, extremes);
  return options.base_triangle ? only_base_triangle(std::move(sc), *options.base_triangle) : sc;
}

scene only_base_triangle(scene sc, int index) {
  const auto count = sc.triangles.size();
  if (index < 0 || static_cast<std::size_t>(index) >= count)
    throw input_error("--base-triangle: " + std::to_string(index) + " is not within 0.." + std::to_string(count - 1) +
                      ", the base triangles of " + sc.options.mesh);
  sc.options.base_triangle = index;
  sc.triangles = {sc.triangles[static_cast<std::size_t>(index)]};
  sc.triangles.front().last = true;
  return sc;
}

}  // namespace relievo::tb
