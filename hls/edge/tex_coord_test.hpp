// tex_coord_test: has the edge reached the resolution of the map?
//   ct is false when the integer texel pair of U12 is that of U1 or of U2        Doggett & Hirche 2000, 2.5 and 3.1.2
//   in    u1, u2, u12  coordinate[2], texels; u12 is the midpoint
//   out   ct
//   exact; initiation interval 1
#pragma once
#include "hls/core/fixed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace hls {

struct tex_coord_test_in {
  fixed<formats::coordinate> u1[2];
  fixed<formats::coordinate> u2[2];
  fixed<formats::coordinate> u12[2];
  RELIEVO_FIELDS(u1, u2, u12)
};
struct tex_coord_test_out {
  bool ct;
  RELIEVO_FIELDS(ct)
};

inline tex_coord_test_out tex_coord_test(tex_coord_test_in const& in) {
  const std::int64_t column = floor_int(in.u12[0]), row = floor_int(in.u12[1]);
  const bool like_first = column == floor_int(in.u1[0]) && row == floor_int(in.u1[1]);
  const bool like_second = column == floor_int(in.u2[0]) && row == floor_int(in.u2[1]);
  return {!like_first && !like_second};
}

}  // namespace hls
}  // namespace relievo
