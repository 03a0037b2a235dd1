// bump: the normal of the displaced surface from the base frame and the normal map.
//   N' = normalize(N m.z + T m.x + B m.y),  B = N x T        Doggett & Hirche 2000, 2.1 (bump mapping of Schilling)
//   in    n, t  unit[3]      normal and tangent of the base surface
//         m     unit[3]      filtered normal of the map
//   out   n     unit[3]      N'
//         saturated          a register clipped
//         zero               nothing was left to normalise; N' is (0,0,1)
//   registers: s0_bitangent (unit), s1_direction (direction), n (unit); initiation interval 1
#pragma once
#include "hls/core/normalize.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace hls {

struct bump_in {
  fixed<formats::unit> n[3];
  fixed<formats::unit> t[3];
  fixed<formats::unit> m[3];
  RELIEVO_FIELDS(n, t, m)
};
struct bump_out {
  fixed<formats::unit> n[3];
  bool saturated;
  bool zero;
  RELIEVO_FIELDS(n, saturated, zero)
};

inline bump_out bump(bump_in const& in) {
  bump_out out;
  out.saturated = false;
  normalize_in s1_direction;
  s1_direction.tangent = false;
  for (int i = 0; i < 3; ++i) {
    const auto s0_bitangent = round_to<formats::unit>(cross(in.n, in.t, i), out.saturated);
    s1_direction.v[i] = round_to<formats::direction>(in.n[i] * in.m[2] + in.t[i] * in.m[0] + s0_bitangent * in.m[1], out.saturated);
  }
  const normalize_out s2_unit = normalize(s1_direction);
  for (int i = 0; i < 3; ++i) out.n[i] = s2_unit.n[i];
  out.zero = s2_unit.zero;
  return out;
}

}  // namespace hls
}  // namespace relievo
