#include "tb/cosim/limited_by.hpp"

#include <algorithm>
#include <cmath>

#include "hls/edge/counters.hpp"

namespace relievo::tb {

namespace {

double share(std::uint64_t part, link_report const& l) {
  const std::uint64_t clocks = l.moved + l.waited + l.idle;
  return clocks == 0 ? 0 : static_cast<double>(part) / static_cast<double>(clocks);
}

// The link that stands highest, or none.
template <class Height>
link_report const* highest(cosim_result const& r, bool answers, Height height) {
  link_report const* best = nullptr;
  for (link_report const& l : r.links)
    if (l.answers == answers && l.moved != 0 && (best == nullptr || height(l) > height(*best))) best = &l;
  return best;
}

// How busy the pipeline was: it takes an edge a clock and lane, and a triangle a clock, base triangles once more for their vertices.
struct counted {
  std::vector<std::uint64_t> const& list;
  std::size_t at = 0;
  std::uint64_t edges = 0, triangles = 0;
  void operator()(char const* name, std::uint64_t) {
    const std::uint64_t count = list[at++];
    if (std::string(name) == "edge_tests") edges = count;
    if (std::string(name) == "triangles_in") triangles += count;
  }
  template <int N>
  void operator()(char const*, std::uint64_t const (&)[N]) {
    for (int i = 0; i < N; ++i) triangles += list[at++];  // by how many edges they split
  }
};

// A lane whose places are nearly all taken by edges that wait for a memory: the one that most wait for, or none. An edge waits for the
// table or its profile, and then for its displacement and normal, so that what both owe is held against the most that one ever owed; the
// few that memories without latency owe say nothing. The bench has the four memories of a lane in this order.
link_report const* awaited(cosim_result const& r) {
  std::vector<link_report const*> memories;
  for (link_report const& l : r.links)
    if (l.answers) memories.push_back(&l);
  const auto more = [](link_report const* a, link_report const* b) { return b->in_flight > a->in_flight ? b : a; };
  for (std::size_t i = 0; i + 3 < memories.size(); i += 4) {
    link_report const* front = more(memories[i], memories[i + 1]);
    link_report const* back = more(memories[i + 2], memories[i + 3]);
    const std::uint64_t most = std::max(front->most_in_flight, back->most_in_flight);
    if (most > 16 && front->in_flight + back->in_flight >= 0.8 * static_cast<double>(most)) return more(front, back);
  }
  return nullptr;
}

}  // namespace

double busy(link_report const& l) { return share(l.moved, l); }

std::string limited_by(cosim_result const& r) {
  link_report const* l = highest(r, true, busy);
  if (l != nullptr && busy(*l) >= 0.9) return l->name + ": one in nearly every clock";
  counted c{r.counters};
  hls::counters().each_field(c);
  const auto clocks = static_cast<double>(r.clocks);
  const auto lanes = static_cast<double>(std::count_if(r.links.begin(), r.links.end(), [](link_report const& x) { return x.answers; })) / 4;
  if (static_cast<double>(c.edges) >= 0.9 * lanes * clocks) return "no memory: the pipeline takes an edge in nearly every clock";
  l = awaited(r);
  if (l != nullptr) return l->name + ": latency, no more are awaited at once";
  // Base triangles wait for the circuit; on all other links words wait for the bench.
  const auto refused = [](link_report const& x) { return x.name == "base triangles" ? 0 : share(x.waited, x); };
  l = highest(r, false, refused);
  if (l != nullptr && refused(*l) >= 0.1)
    return l->name + ": refused in " + std::to_string(std::lround(100 * refused(*l))) + " % of the clocks";
  if (static_cast<double>(c.triangles) >= 0.85 * clocks) return "no memory: the pipeline takes a triangle in nearly every clock";
  return "the way of a triangle through pipeline and memories, of which too few were under way, or a source that rests";
}

}  // namespace relievo::tb
