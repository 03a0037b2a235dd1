// counters: what the edge engine counted while a mesh ran through it. None of them depends on time.
//
//   triangles_in, triangles_out, culled
//   edge_tests         edges evaluated;  settled_skips   edges met settled, tests saved (by the generation limit too)
//   vt, ct             edges that this enabled test stopped (ct: of those that vt let through)
//   nt, sht, pt, ht    edges that reached this enabled test and where it was true
//   splits[i]          triangles with i split edges
//   vertices           base vertices set up, and new vertices of split edges
//   queue_high_water, fifo_fallbacks   see triangle_queue
//   saturations        displace_vertex and bump, screen_saturations   transform: of vertices that entered the mesh
//   zero_vectors       zero vectors normalised on the way to a vertex that entered the mesh
//   table_reads        12 per summed height test;  profile_samples   n + 1 per profile
#pragma once
#include <cstdint>

#include "hls/core/record.hpp"

namespace relievo {
namespace golden {

struct counters {
  std::uint64_t triangles_in = 0, triangles_out = 0, culled = 0;
  std::uint64_t edge_tests = 0, settled_skips = 0;
  std::uint64_t vt = 0, ct = 0, nt = 0, sht = 0, pt = 0, ht = 0;
  std::uint64_t splits[4] = {0, 0, 0, 0};
  std::uint64_t vertices = 0;
  std::uint64_t queue_high_water = 0, fifo_fallbacks = 0;
  std::uint64_t saturations = 0, screen_saturations = 0, zero_vectors = 0;
  std::uint64_t table_reads = 0, profile_samples = 0;

  // More fields than one list of record.hpp holds.
  template <class Visitor>
  void each_field(Visitor&& visitor) {
    visit(*this, visitor);
  }
  template <class Visitor>
  void each_field(Visitor&& visitor) const {
    visit(*this, visitor);
  }

 private:
  template <class Self, class Visitor>
  static void visit(Self& s, Visitor& visitor);
};

template <class Self, class Visitor>
void counters::visit(Self& s, Visitor& visitor) {
  visitor("triangles_in", s.triangles_in);
  visitor("triangles_out", s.triangles_out);
  visitor("culled", s.culled);
  visitor("edge_tests", s.edge_tests);
  visitor("settled_skips", s.settled_skips);
  visitor("vt", s.vt);
  visitor("ct", s.ct);
  visitor("nt", s.nt);
  visitor("sht", s.sht);
  visitor("pt", s.pt);
  visitor("ht", s.ht);
  visitor("splits", s.splits);
  visitor("vertices", s.vertices);
  visitor("queue_high_water", s.queue_high_water);
  visitor("fifo_fallbacks", s.fifo_fallbacks);
  visitor("saturations", s.saturations);
  visitor("screen_saturations", s.screen_saturations);
  visitor("zero_vectors", s.zero_vectors);
  visitor("table_reads", s.table_reads);
  visitor("profile_samples", s.profile_samples);
}

}  // namespace golden
}  // namespace relievo
