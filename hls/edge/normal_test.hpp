// normal_test: does the displaced normal at the new vertex differ from that at either end?
//   nt = any |N'12_i - N'1_i| > nthr or |N'12_i - N'2_i| > nthr    Doggett & Hirche 2000, 2.2 (printed with <; the sentence above says >)
//   in    n1, n2, n12  unit[3], the displaced normals N' of the ends and of the new vertex
//   regs  threshold    normal_threshold
//   out   nt
//   exact; initiation interval 1
#pragma once
#include "hls/core/fixed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace hls {

struct normal_test_in {
  fixed<formats::unit> n1[3];
  fixed<formats::unit> n2[3];
  fixed<formats::unit> n12[3];
  RELIEVO_FIELDS(n1, n2, n12)
};
struct normal_test_regs {
  fixed<formats::normal_threshold> threshold;
  RELIEVO_FIELDS(threshold)
};
struct normal_test_out {
  bool nt;
  RELIEVO_FIELDS(nt)
};

inline normal_test_out normal_test(normal_test_in const& in, normal_test_regs const& regs) {
  normal_test_out out = {false};
  for (int i = 0; i < 3; ++i) {
    out.nt |= magnitude(in.n12[i] - in.n1[i]) > regs.threshold;
    out.nt |= magnitude(in.n12[i] - in.n2[i]) > regs.threshold;
  }
  return out;
}

}  // namespace hls
}  // namespace relievo
