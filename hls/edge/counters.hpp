// counters: what the engine counts while a mesh runs; none of it depends on time, so every model counts the same.
//   triangles_in, triangles_out, culled
//   edge_tests       edges tested: not settled when their triangle came by
//   settled_skips    edges met settled: tests saved
//   vt, ct           edges that this test stopped (vt is asked first)
//   nt, sht, pt, ht  edges that got past those and on which this test was true
//   splits[n]        triangles with n split edges
//   vertices         vertices displaced: base vertices and inserted ones
//   queue_high_water, fifo_fallbacks
//   saturations      displace or bump clipped, screen_saturations transform did, zero_vectors a vector vanished: each counted for
//                    vertices that enter the mesh
//   table_reads      12 a summed height test, three rectangles of four corners (corners beyond a wrapped border read more words)
//   profile_samples  n + 1 a profile
#pragma once
#include <cstdint>

#include "hls/core/record.hpp"

namespace relievo {
namespace hls {

struct counters {
  std::uint64_t triangles_in = 0, triangles_out = 0, culled = 0;
  std::uint64_t edge_tests = 0, settled_skips = 0;
  std::uint64_t vt = 0, ct = 0, nt = 0, sht = 0, pt = 0, ht = 0;
  std::uint64_t splits[4] = {0, 0, 0, 0};
  std::uint64_t vertices = 0, queue_high_water = 0, fifo_fallbacks = 0;
  std::uint64_t saturations = 0, screen_saturations = 0, zero_vectors = 0;
  std::uint64_t table_reads = 0, profile_samples = 0;

  template <class Visitor>
  void each_field(Visitor&& visitor) const {
    RELIEVO_EACH_FIELD(visitor, triangles_in, triangles_out, culled, edge_tests, settled_skips, vt, ct, nt, sht, pt, ht, splits)
    RELIEVO_EACH_FIELD(visitor, vertices, queue_high_water, fifo_fallbacks, saturations, screen_saturations, zero_vectors, table_reads,
                       profile_samples)
  }
};

}  // namespace hls
}  // namespace relievo
