#include "tb/host/scene_registers.hpp"

#include <algorithm>
#include <cmath>

#include "tb/host/quantise.hpp"

namespace relievo::tb {

namespace {

// direction's z component is 2^-shift and has to be a value of that format.
constexpr int largest_shift = formats::direction::fraction;

// Both gradients with this shift, or nothing when a register or the steepest direction does not fit.
std::optional<golden::normal_map_regs> with_shift(glm::dvec2 gradient, map_extremes const& extremes, int shift) {
  glm::dvec2 fitted(0.0);
  for (int axis = 0; axis < 2; ++axis) {
    const int delta = axis == 0 ? extremes.max_delta_u : extremes.max_delta_v;
    if (delta == 0) continue;  // flat along this axis: its gradient meets nothing but zeros
    const double scaled = std::ldexp(gradient[axis], -shift);
    if (!fits<formats::gradient>(scaled)) return std::nullopt;
    fitted[axis] = round_half_up<formats::gradient>(scaled);
    if (!fits<formats::direction>(fitted[axis] * delta) || !fits<formats::direction>(-fitted[axis] * delta)) return std::nullopt;
  }
  golden::normal_map_regs regs;
  regs.gradient_u = fitted.x;
  regs.gradient_v = fitted.y;
  regs.normal_shift = shift;
  return regs;
}

int default_generations(std::vector<golden::triangle> const& triangles) {
  double longest = 0.0;
  for (golden::triangle const& t : triangles) {
    for (int e = 0; e < 3; ++e) {
      const glm::dvec2 d = glm::abs(t.v[e].u - t.v[(e + 1) % 3].u);
      longest = std::max({longest, d.x, d.y});
    }
  }
  int generations = 0;
  while (std::ldexp(1.0, generations) < longest) ++generations;
  return std::min(generations + 1, 15);
}

glm::dvec3 default_half_vector(camera_view const& view) {
  const glm::dvec3 to_eye = glm::normalize(view.eye - view.at);
  const glm::dvec3 above = glm::normalize(glm::cross(to_eye, glm::cross(view.up, to_eye)));
  return glm::normalize(to_eye + glm::normalize(to_eye + above));
}

}  // namespace

void set_displacement(scene& sc) {
  sc.regs.displace.scale = quantise<formats::scale>(sc.world_per_sample() * sc.world_scale, "--scale", sc.world_scale / 65535.0);
  sc.regs.displace.bias = quantise<formats::height>(sc.options.bias * sc.world_scale, "--bias", sc.world_scale);
}

void set_normal_map(scene& sc, map_extremes const& extremes) {
  if (sc.options.texel_size) {
    sc.texel_size = *sc.options.texel_size;
    for (int axis = 0; axis < 2; ++axis)
      if (!(sc.texel_size[axis] > 0.0) || !std::isfinite(sc.texel_size[axis]))
        throw input_error("--texel-size: " + shown(sc.texel_size.x) + "," + shown(sc.texel_size.y) + ": two numbers above 0 are needed");
  } else {
    const std::optional<glm::dvec2> size = estimate_texel_size(sc.base, sc.texels_per_unit());
    if (!size)
      throw input_error(sc.base.name +
                        ": no triangle has an area both in space and in its texture coordinates, so the size of a texel is "
                        "unknown; --texel-size DU,DV is needed");
    sc.texel_size = *size;
  }
  sc.options.texel_size = sc.texel_size;
  const glm::dvec2 gradient = sc.world_per_sample() / (2.0 * sc.texel_size);
  for (int shift = 0; shift <= largest_shift; ++shift) {
    if (const auto regs = with_shift(gradient, extremes, shift)) {
      sc.normal_map = *regs;
      return;
    }
  }
  const double slope = std::fmax(std::abs(gradient.x) * extremes.max_delta_u, std::abs(gradient.y) * extremes.max_delta_v);
  throw input_error("--scale, --texel-size: the map's steepest slope is " + shown(slope) + "; up to " +
                    shown(std::ldexp(max_of<formats::direction>(), largest_shift)) + " is possible");
}

void set_tests(scene& sc, map_extremes const& extremes) {
  scene_options& o = sc.options;
  golden::engine_regs& regs = sc.regs;
  regs.normal.threshold = quantise<formats::normal_threshold>(o.normal_threshold, "--normal-threshold");

  const double samples_per_unit = 1.0 / sc.physical_per_sample();
  const double hundredth = std::fmax(1.0, (extremes.max - extremes.min) / 100.0) / samples_per_unit;
  if (!o.height_threshold) o.height_threshold = o.height_average ? hundredth : 64.0 * hundredth;
  if (!o.profile_threshold) o.profile_threshold = hundredth;
  regs.summed_height.average = o.height_average;
  if (o.height_average) {
    regs.summed_height.average_threshold =
        quantise<formats::average_threshold>(*o.height_threshold * samples_per_unit, "--height-threshold", samples_per_unit);
  } else {
    regs.summed_height.sum_threshold =
        quantise<formats::sum_threshold>(*o.height_threshold * samples_per_unit, "--height-threshold", samples_per_unit);
  }
  regs.profile.threshold =
      quantise<formats::profile_threshold>(*o.profile_threshold * samples_per_unit, "--profile-threshold", samples_per_unit);
  regs.view.threshold = quantise<formats::view_threshold>(o.view_threshold, "--view-threshold");

  if (!o.half_vector) o.half_vector = default_half_vector(sc.camera);
  const double length = glm::length(*o.half_vector);
  if (!(length > 1e-30) || !std::isfinite(length)) throw input_error("--half-vector: a vector with a length is needed");
  for (int i = 0; i < 3; ++i) regs.highlight.half_vector[i] = round_half_up<formats::unit>((*o.half_vector / length)[i]);
  regs.highlight.threshold = quantise<formats::unit>(o.highlight_threshold, "--highlight-threshold");

  if (!o.max_generation) o.max_generation = default_generations(sc.triangles);
  if (*o.max_generation < 0 || *o.max_generation > 15)
    throw input_error("--max-generation: " + std::to_string(*o.max_generation) + "; from 0 to 15 is possible");
  regs.pass.use_nt = o.tests.nt;
  regs.pass.use_sht = o.tests.sht;
  regs.pass.use_pt = o.tests.pt;
  regs.pass.use_ht = o.tests.ht;
  regs.pass.use_vt = o.tests.vt;
  regs.pass.use_ct = o.tests.ct;
  regs.pass.max_generation = *o.max_generation;
  regs.pass.cull = o.cull;
  regs.queue.fifo = o.fifo;
}

}  // namespace relievo::tb
