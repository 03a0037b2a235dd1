// variational_level: the filter level with a small volume between it and the map.   Gumhold & Huettner 1999, 4.2, eq. 12
//
//   Begins at the averaged level. Every texel moves at once by -lambda dV_i (difference_volume.hpp) as long as the volume falls; where it
//   does not, the step is taken back and lambda halved, from 2^0 down to 2^-2; then it is done. Heights stay within the words' range and
//   are rounded to words at the end, halves up; if the words have no smaller volume than the averaged ones, those stay. eps = 10^-4 and
//   lambda count in a unit of displacement that the paper does not name. Here it is the mean distance between the averaged level and the
//   map, V / (W H): levels of a map twice as high are then twice as high. A sample as the unit needs thousands of passes and stops earlier,
//   the map's whole range oscillates from the start on fine levels. V is convex in the heights; what is left to gain by a smaller lambda is
//   below 1 % of it on the terrain of tests/data. A map of a few samples of relief has less to gain: texels of the map that lie on the
//   level stop it, as the quotient looks upwards alone. No errors.
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tb/host/difference_volume.hpp"
#include "tb/host/level_words.hpp"

namespace relievo::tb {

struct fitted_level {
  displacement_map level;
  int passes = 0;                    // over the map, each for V and all its derivatives
  double before = 0.0, after = 0.0;  // V of the averaged words and of these
};

// At most `most_passes`; `tick()` is called after each.
template <class Tick>
fitted_level variational_level(displacement_map const& map, int level, int most_passes, Tick const& tick) {
  constexpr double smallest_lambda = 0.25, highest = 65535.0;
  const difference_volume volume(map, level);
  fitted_level out{averaged_level(map, level), 0, 0.0, 0.0};
  std::vector<double> heights(out.level.texels.begin(), out.level.texels.end()), slopes;
  out.before = out.after = volume.of(heights);
  const double unit = out.before / (static_cast<double>(map.width) * map.height), eps = 1e-4 * unit;
  if (unit == 0.0) return out;
  double least = volume.with_slopes(heights, eps, slopes);
  std::vector<double> moved = heights, moved_slopes;
  for (double lambda = 1.0; lambda >= smallest_lambda && out.passes < most_passes; ++out.passes) {
    for (std::size_t i = 0; i < heights.size(); ++i) moved[i] = std::clamp(heights[i] - lambda * unit * slopes[i], 0.0, highest);
    const double now = volume.with_slopes(moved, eps, moved_slopes);
    if (now < least) {
      least = now;
      std::swap(heights, moved);
      std::swap(slopes, moved_slopes);
    } else {
      lambda /= 2.0;
    }
    tick();
  }
  for (double& height : heights) height = std::floor(height + 0.5);
  const double rounded = volume.of(heights);
  if (rounded >= out.before) return out;
  out.after = rounded;
  std::transform(heights.begin(), heights.end(), out.level.texels.begin(),
                 [](double height) { return static_cast<std::uint16_t>(height); });
  return out;
}

}  // namespace relievo::tb
