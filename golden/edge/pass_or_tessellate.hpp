// pass_or_tessellate: is the edge split? Is the finished triangle culled?     Doggett & Hirche 2000, sections 2.6 and 3.1.5
//   split = (nt | sht | pt | ht) & vt & ct
//
//   in    nt, sht, pt, ht, vt, ct;  generation   generation;  settled   of the edge
//   regs  use_*            a test that is not used neither asks for a split nor stops one
//         max_generation   generation   an edge splits only below it: as printed the recursion does not end
//         cull             drop finished triangles that show their back at all three vertices
//   out   split
#pragma once
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct pass_or_tessellate_in {
  bool nt = false, sht = false, pt = false, ht = false, vt = false, ct = false;
  double generation = 0;
  bool settled = false;
  RELIEVO_FIELDS(nt, sht, pt, ht, vt, ct, generation, settled)
};
struct pass_or_tessellate_regs {
  bool use_nt = false, use_sht = false, use_pt = false, use_ht = false, use_vt = false, use_ct = false;
  double max_generation = 0;
  bool cull = false;
  RELIEVO_FIELDS(use_nt, use_sht, use_pt, use_ht, use_vt, use_ct, max_generation, cull)
};
struct pass_or_tessellate_out {
  bool split = false;
  RELIEVO_FIELDS(split)
};

template <class Rounding>
pass_or_tessellate_out pass_or_tessellate(pass_or_tessellate_in const& in, pass_or_tessellate_regs const& regs) {
  const bool wanted = (in.nt && regs.use_nt) || (in.sht && regs.use_sht) || (in.pt && regs.use_pt) || (in.ht && regs.use_ht);
  const bool let = (in.vt || !regs.use_vt) && (in.ct || !regs.use_ct);
  return {!in.settled && in.generation < regs.max_generation && wanted && let};
}

// cull: asked only when no edge of the triangle splits.
template <class Rounding>
bool cull(bool const (&away)[3], pass_or_tessellate_regs const& regs) {
  return regs.cull && away[0] && away[1] && away[2];
}

}  // namespace golden
}  // namespace relievo
