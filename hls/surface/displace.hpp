// displace: move a point along its normal by the scaled displacement.
//   P' = P + (s D + b) N                        Doggett & Hirche 2000, eq. 1 and 5.1
//   in    p   position       on the base surface, world units
//         n   unit           unit normal there
//         d   sample         filtered displacement
//   regs  scale s, bias b    constant while a scene runs
//   out   p   position       saturates at the ends of its range
//         saturated          a register clipped (counted by the engine)
//   registers: s0_height (height), p (position); initiation interval 1
#pragma once
#include "hls/core/fixed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace hls {

struct displace_in {
  fixed<formats::position> p[3];
  fixed<formats::unit> n[3];
  fixed<formats::sample> d;
  RELIEVO_FIELDS(p, n, d)
};
struct displace_regs {
  fixed<formats::scale> scale;
  fixed<formats::height> bias;
  RELIEVO_FIELDS(scale, bias)
};
struct displace_out {
  fixed<formats::position> p[3];
  bool saturated;
  RELIEVO_FIELDS(p, saturated)
};

inline displace_out displace(displace_in const& in, displace_regs const& regs) {
  displace_out out;
  out.saturated = false;
  const auto s0_height = round_to<formats::height>(regs.scale * in.d + regs.bias, out.saturated);
  for (int i = 0; i < 3; ++i) {
    const auto s1_offset = s0_height * in.n[i];
    out.p[i] = round_to<formats::position>(in.p[i] + s1_offset, out.saturated);
  }
  return out;
}

}  // namespace hls
}  // namespace relievo
