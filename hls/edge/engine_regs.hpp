// engine_regs: all registers of the edge engine, taken over at start and constant until the mesh has drained (settled edges and
// crack-freeness rely on that), and the memories it reads.
#pragma once
#include "hls/edge/highlight_test.hpp"
#include "hls/edge/normal_test.hpp"
#include "hls/edge/pass_or_tessellate.hpp"
#include "hls/edge/profile_test.hpp"
#include "hls/edge/summed_height_test.hpp"
#include "hls/edge/triangle_queue.hpp"
#include "hls/edge/view_test.hpp"
#include "hls/surface/displace.hpp"
#include "hls/surface/transform.hpp"
#include "hls/surface/transform_normal.hpp"

namespace relievo {
namespace hls {

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

struct engine_memories {
  texel_memory displacement;
  table_memory table;
  normal_memory normals;
};

}  // namespace hls
}  // namespace relievo
