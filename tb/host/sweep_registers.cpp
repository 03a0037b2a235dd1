#include "tb/host/sweep_registers.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "golden/sweep/base_triangle_clip.hpp"
#include "golden/sweep/grid_transform.hpp"
#include "golden/sweep/z_table.hpp"
#include "tb/host/quantise.hpp"

namespace relievo::tb {

namespace {

constexpr double pi = 3.14159265358979323846;

// A cut vertex may be nearer than near by so much: golden/sweep/near_clip.hpp.
constexpr double least_before_w_min = 64 * 0x1p-20;

template <class F>
double rounded_up(double x) {
  return std::ceil(x * (1.0 + 0x1p-13) / lsb_of<F>()) * lsb_of<F>();
}

void set_depths(scene& sc) {
  golden::sweep_regs& r = sc.sweep;
  const double w_per_world = std::ldexp(sc.world_scale, sc.row_exponent);
  r.near = quantise<formats::depth>(*sc.options.near * w_per_world, "--near", w_per_world);
  r.far = round_half_up<formats::depth>(std::min(*sc.options.far * w_per_world, max_of<formats::depth>()));
  const double least = std::max(r.transform.w_min + least_before_w_min, 0x1p-20 * std::max(sc.camera.width, sc.camera.height));
  if (r.near < least)
    throw input_error("--near: " + shown(*sc.options.near) + " is too near for a scene of this size; from " + shown(least / w_per_world) +
                      " is possible");
  if (!(r.far > r.near))
    throw input_error("--near, --far: " + shown(*sc.options.near) + " and " + shown(*sc.options.far) +
                      " are the same depth to the engine; a farther --far is needed");
}

void set_grid(scene& sc) {
  golden::sweep_regs& r = sc.sweep;
  const double grid = sc.options.grid;
  if (!(grid >= 1.0 && grid <= 8191.0)) throw input_error("--grid: " + shown(grid) + " pixels; from 1 to 8191 is possible");
  r.grid.cells_per_pixel = quantise<formats::cells>(1.0 / grid, "--grid");
  const double per_cell = 2.0 * grid * std::tan(sc.camera.fov_degrees * pi / 360.0) / sc.camera.height;
  const double kappa = 1.0 / std::log1p(per_cell), steps = kappa * std::log(r.far / r.near);
  if (!(steps <= most_steps + 0.5))
    throw input_error("--near, --far, --grid: " + shown(std::round(steps)) + " steps of the grid from near to far; up to " +
                      std::to_string(most_steps) + " are possible: a larger --grid, or planes nearer to each other");
  r.kappa = quantise<formats::kappa>(kappa, "--fov, --viewport, --grid: cells for each factor e of depth");
  const std::vector<double> table = golden::z_table_of(r.kappa);
  r.grid.octave = table.back();
  r.grid.near_cells = golden::depth_cells_of(r.near, r.grid.octave, table);
}

void set_bounds(scene& sc, map_extremes const& extremes) {
  golden::sweep_regs& r = sc.sweep;
  r.viewport = {sc.camera.width, sc.camera.height};
  r.reach = {rounded_up<formats::reach>(glm::length(r.transform.row_x)), rounded_up<formats::reach>(glm::length(r.transform.row_y))};
  r.d_scale = rounded_up<formats::matrix_w>(glm::length(r.transform.row_w));
  const auto highest = [&](int, int, int) { return extremes.max; };
  const auto lowest = [&](int, int, int) { return extremes.min; };
  r.d_max = golden::d_max_of({}, r.map, r.displace, highest, lowest).d_max;
}

}  // namespace

void set_sweep(scene& sc, map_extremes const& extremes) {
  golden::sweep_regs& r = sc.sweep;
  r.map = sc.regs.map;
  r.displace = sc.regs.displace;
  r.transform = sc.regs.transform;
  r.guard = true;
  r.limit = sc.texels_per_unit();
  set_depths(sc);
  set_grid(sc);
  set_bounds(sc, extremes);
}

}  // namespace relievo::tb
