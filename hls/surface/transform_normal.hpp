// transform_normal: the displaced normal into the eye's frame, and whether it points away from the eye.
//   N'_s = R N';  away = N' . (P' - E) > 0, exact            Doggett & Hirche 2000, 3.1.5 (back-face culling after tessellation)
//   in    p  position[3] P';  n  unit[3] N'
//   regs  rotation  unit[3][3], rows right, down, forward of the camera;  eye  eye[3]
//   out   n  unit[3] N'_s;  away
//   A rotation keeps N' within [-1.1, 1.1], so nothing clips for the host's registers.
//   initiation interval 1
#pragma once
#include "hls/core/record.hpp"
#include "hls/core/vector.hpp"

namespace relievo {
namespace hls {

struct transform_normal_in {
  fixed<formats::position> p[3];
  fixed<formats::unit> n[3];
  RELIEVO_FIELDS(p, n)
};
struct transform_normal_regs {
  fixed<formats::unit> rotation[3][3];
  fixed<formats::eye> eye[3];
  RELIEVO_FIELDS(rotation, eye)
};
struct transform_normal_out {
  fixed<formats::unit> n[3];
  bool away;
  RELIEVO_FIELDS(n, away)
};

inline transform_normal_out transform_normal(transform_normal_in const& in, transform_normal_regs const& regs) {
  transform_normal_out out;
  for (int i = 0; i < 3; ++i) out.n[i] = round_to<formats::unit>(dot(regs.rotation[i], in.n));
  const auto s0_facing = in.n[0] * (in.p[0] - regs.eye[0]) + in.n[1] * (in.p[1] - regs.eye[1]) + in.n[2] * (in.p[2] - regs.eye[2]);
  out.away = raw(s0_facing) > 0;
  return out;
}

}  // namespace hls
}  // namespace relievo
