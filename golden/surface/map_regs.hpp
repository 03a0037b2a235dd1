// map_regs: size of the displacement map and how each axis continues past its ends. Constant while a scene runs.
//
//   regs  width, height   map_size   texels along u and v, 1..8192
//         wrap_u, wrap_v             true: the axis closes on itself, coordinate W is 0 again; false: clamped
#pragma once
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct map_regs {
  double width = 1;
  double height = 1;
  bool wrap_u = false;
  bool wrap_v = false;
  RELIEVO_FIELDS(width, height, wrap_u, wrap_v)
};

}  // namespace golden
}  // namespace relievo
