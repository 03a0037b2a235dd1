// uniform_grid: the error of a regular grid over the map, computed cell by cell without building the mesh.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tb/analysis/error.hpp"
#include "tb/analysis/error_sums.hpp"

namespace relievo::tb {
namespace {

// Texels that an axis spans between its first and last grid line: on a wrapped axis the last one is texel 0 again.
int span(int texels, bool wrap) { return std::max(1, wrap ? texels : texels - 1); }

double bilinear(height_map const& map, double x, double y) {
  const auto index = [](int i, int size, bool wrap) { return wrap ? i % size : std::min(i, size - 1); };
  const int xi = static_cast<int>(std::floor(x));
  const int yi = static_cast<int>(std::floor(y));
  const double fx = x - xi;
  const double fy = y - yi;
  const auto at = [&](int i, int j) {
    const auto column = static_cast<std::size_t>(index(i, map.width, map.wrap_u));
    const auto row = static_cast<std::size_t>(index(j, map.height, map.wrap_v));
    return static_cast<double>(map.texels[row * static_cast<std::size_t>(map.width) + column]);
  };
  const double low = at(xi, yi) * (1.0 - fx) + at(xi + 1, yi) * fx;
  const double high = at(xi, yi + 1) * (1.0 - fx) + at(xi + 1, yi + 1) * fx;
  return low * (1.0 - fy) + high * fy;
}

void choose_cells(double aspect, double cells, int& columns, int& rows) {
  const int guess = std::max(1, static_cast<int>(std::lround(std::sqrt(cells * aspect))));
  double best = -1.0;
  for (int n = std::max(1, guess - 2); n <= guess + 2; ++n) {
    const int m = std::max(1, static_cast<int>(std::lround(cells / n)));
    const double misfit = std::abs(std::log(static_cast<double>(n) / m / aspect)) + std::abs(std::log(static_cast<double>(n) * m / cells));
    if (best < 0.0 || misfit < best) {
      best = misfit;
      columns = n;
      rows = m;
    }
  }
}

}  // namespace

uniform_grid_report uniform_grid_error(height_map const& map, std::uint64_t triangles) {
  uniform_grid_report report;
  const int span_x = span(map.width, map.wrap_u);
  const int span_y = span(map.height, map.wrap_v);
  choose_cells(static_cast<double>(span_x) / span_y, std::max(1.0, static_cast<double>(triangles) / 2.0), report.columns, report.rows);
  const int columns = report.columns;
  const int rows = report.rows;
  report.triangles = 2u * static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows);

  const auto stride = static_cast<std::size_t>(columns) + 1;
  std::vector<double> height(stride * (static_cast<std::size_t>(rows) + 1));
  for (int r = 0; r <= rows; ++r) {
    for (int c = 0; c <= columns; ++c) {
      height[static_cast<std::size_t>(r) * stride + static_cast<std::size_t>(c)] =
          bilinear(map, static_cast<double>(c) * span_x / columns, static_cast<double>(r) * span_y / rows);
    }
  }

  error_sums sums;
  for (int j = 0; j < map.height; ++j) {
    // Cell and place in it, exactly: texel j is j * rows / span_y grid lines from the first.
    const std::int64_t down = std::int64_t{j} * rows;
    const auto r = std::min<std::int64_t>(down / span_y, rows - 1);
    const double fy = static_cast<double>(down - r * span_y) / span_y;
    for (int i = 0; i < map.width; ++i) {
      const std::int64_t along = std::int64_t{i} * columns;
      const auto c = std::min<std::int64_t>(along / span_x, columns - 1);
      const double fx = static_cast<double>(along - c * span_x) / span_x;
      double const* low = &height[static_cast<std::size_t>(r) * stride + static_cast<std::size_t>(c)];
      double const* high = low + stride;
      const double value = fx >= fy ? low[0] + fx * (low[1] - low[0]) + fy * (high[1] - low[1])
                                    : low[0] + fy * (high[0] - low[0]) + fx * (high[1] - high[0]);
      const double truth = map.texels[static_cast<std::size_t>(j) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(i)];
      sums.add((value - truth) * map.scale, i, j);
    }
  }
  report.error.along_normal = true;
  sums.fill(report.error, map);
  return report;
}

}  // namespace relievo::tb
