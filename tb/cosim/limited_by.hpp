// limited_by: what took the clocks of a run, by the name of a link:
//   NAME answers: one in nearly every clock             a memory that delivers all it can
//   no memory: the pipeline takes an edge in nearly every clock, or a triangle: its lanes have no more
//   NAME answers: latency, no more are awaited at once  nearly as many edges as the circuit allows wait for memories
//   NAME: refused in N % of the clocks                  a sink or a memory that lets words wait, the one that does it most
//   the way of a triangle ...                           else: too few were under way, or the source rested
#pragma once
#include <string>

#include "tb/cosim/engine_bench.hpp"

namespace relievo::tb {

// The share of the clocks in which a word moved.
double busy(link_report const& l);
std::string limited_by(cosim_result const& r);

}  // namespace relievo::tb
