// highlight_test: does an end or the new vertex lie in a Phong highlight?
//   ht = any N' . H > hthr                                    Doggett & Hirche 2000, 5.1 (proposed there, not specified)
//   in    n1, n2, n12  unit[3], the displaced normals N' of the ends and of the new vertex
//   regs  half_vector  unit[3]: directional light and viewer at infinity, so the test stays a matter of the edge alone
//         threshold    unit
//   out   ht
//   exact; initiation interval 1
#pragma once
#include "hls/core/record.hpp"
#include "hls/core/vector.hpp"

namespace relievo {
namespace hls {

struct highlight_test_in {
  fixed<formats::unit> n1[3];
  fixed<formats::unit> n2[3];
  fixed<formats::unit> n12[3];
  RELIEVO_FIELDS(n1, n2, n12)
};
struct highlight_test_regs {
  fixed<formats::unit> half_vector[3];
  fixed<formats::unit> threshold;
  RELIEVO_FIELDS(half_vector, threshold)
};
struct highlight_test_out {
  bool ht;
  RELIEVO_FIELDS(ht)
};

inline highlight_test_out highlight_test(highlight_test_in const& in, highlight_test_regs const& regs) {
  return {dot(in.n1, regs.half_vector) > regs.threshold || dot(in.n2, regs.half_vector) > regs.threshold ||
          dot(in.n12, regs.half_vector) > regs.threshold};
}

}  // namespace hls
}  // namespace relievo
