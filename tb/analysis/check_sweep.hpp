// check_sweep: is what the sweep engine put out whole? The exact check, piece by piece (check.hpp).
//
//   The pieces that near_clip left of the base triangles stand for the base mesh: neighbours have the same words at a cut, so its sides
//   are shared there as anywhere. A piece that was rejected, or of which view_volume_clip left triangles out, need not be covered; how
//   many those are in all has to be what the engine counted.
#pragma once
#include "tb/analysis/check.hpp"
#include "tb/model/model.hpp"

namespace relievo::tb {

check_report check_sweep(run_result const& run, golden::map_regs const& map);

}  // namespace relievo::tb
