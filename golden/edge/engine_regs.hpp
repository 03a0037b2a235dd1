// engine_regs: every register of the edge engine, already quantised to its format for every model, the ideal one too.
// Taken over at the start of a mesh and constant until it has drained; settled edges rely on it.
#pragma once
#include "golden/edge/highlight_test.hpp"
#include "golden/edge/normal_test.hpp"
#include "golden/edge/pass_or_tessellate.hpp"
#include "golden/edge/profile_test.hpp"
#include "golden/edge/summed_height_test.hpp"
#include "golden/edge/triangle_queue.hpp"
#include "golden/edge/view_test.hpp"
#include "golden/surface/displace.hpp"
#include "golden/surface/map_regs.hpp"
#include "golden/surface/transform.hpp"
#include "golden/surface/transform_normal.hpp"
#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct engine_regs {
  map_regs map;
  displace_regs displace;
  transform_regs transform;
  transform_normal_regs transform_normal;
  normal_test_regs normal;
  summed_height_test_regs summed_height;
  view_test_regs view;
  highlight_test_regs highlight;
  profile_test_regs profile;
  pass_or_tessellate_regs pass;
  triangle_queue_regs queue;
  RELIEVO_FIELDS(map, displace, transform, transform_normal, normal, summed_height, view, highlight, profile, pass, queue)
};

}  // namespace golden
}  // namespace relievo
