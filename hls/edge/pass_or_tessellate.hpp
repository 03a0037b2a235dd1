// pass_or_tessellate: combines the tests of an edge, and decides whether a finished triangle is put out.
//   split = (nt | sht | pt | ht) & vt & ct                    Doggett & Hirche 2000, 2.6 and 3.1.5; pt and ht are additions
//   in    nt, sht, pt, ht, vt, ct;  generation;  settled
//   regs  use_*            a test that is off counts as false among the first four, as true for vt and ct
//         max_generation   an edge splits only below it
//         cull             back faces are dropped after tessellation
//   out   split
//   cull: a triangle is dropped when the displaced normals of all three vertices point away from the eye
//   initiation interval 1
#pragma once
#include "hls/core/fixed.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace hls {

struct pass_or_tessellate_in {
  bool nt;
  bool sht;
  bool pt;
  bool ht;
  bool vt;
  bool ct;
  fixed<formats::generation> generation;
  bool settled;
  RELIEVO_FIELDS(nt, sht, pt, ht, vt, ct, generation, settled)
};
struct pass_or_tessellate_regs {
  bool use_nt;
  bool use_sht;
  bool use_pt;
  bool use_ht;
  bool use_vt;
  bool use_ct;
  fixed<formats::generation> max_generation;
  bool cull;
  RELIEVO_FIELDS(use_nt, use_sht, use_pt, use_ht, use_vt, use_ct, max_generation, cull)
};
struct pass_or_tessellate_out {
  bool split;
  RELIEVO_FIELDS(split)
};

inline pass_or_tessellate_out pass_or_tessellate(pass_or_tessellate_in const& in, pass_or_tessellate_regs const& regs) {
  const bool wanted = (in.nt && regs.use_nt) || (in.sht && regs.use_sht) || (in.pt && regs.use_pt) || (in.ht && regs.use_ht);
  const bool allowed = (in.vt || !regs.use_vt) && (in.ct || !regs.use_ct);
  return {!in.settled && in.generation < regs.max_generation && wanted && allowed};
}

inline bool cull(bool const (&away)[3], pass_or_tessellate_regs const& regs) { return regs.cull && away[0] && away[1] && away[2]; }

}  // namespace hls
}  // namespace relievo
