// main_direction: the axis along which an edge is subdivided, and into how many steps.
//   n = max(|dx|, |dy|, |dz|), axis the first that has it                 Gumhold & Huettner 1999, definition 1, Figure 11
//   in    p     grid[2][3], the two ends; exchanging them changes nothing
//   out   axis  0 x, 1 y, 2 z;  n  steps
//   exact; initiation interval 1
#pragma once
#include "hls/sweep/remeshed.hpp"

namespace relievo {
namespace hls {

struct main_direction_in {
  fixed<formats::grid> p[2][3];
  RELIEVO_FIELDS(p)
};
struct main_direction_out {
  two_bits axis;
  fixed<formats::steps> n;
  RELIEVO_FIELDS(axis, n)
};

inline main_direction_out main_direction(main_direction_in const& in) {
  main_direction_out out = {detail::two(0), wrap_to<formats::steps>(magnitude(in.p[1][0] - in.p[0][0]))};
  for (int axis = 1; axis < 3; ++axis) {
    // At most 65535: 16 bits.
    const auto n = wrap_to<formats::steps>(magnitude(in.p[1][axis] - in.p[0][axis]));
    if (n > out.n) out = {detail::two(axis), n};
  }
  return out;
}

}  // namespace hls
}  // namespace relievo
