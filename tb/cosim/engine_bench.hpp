// engine_bench: the circuit of the edge engine among SystemC modules: a source of base triangles, a sink, memories behind its read ports,
// a checker on every link, and a watchdog.
//
//   the_engine_bench(settings)   one a process (SystemC elaborates once); other settings in the same process are an error
//   bench.run(scene, out)        one mesh; again and again, with or without a reset between them
//   Errors: cosim_error when a rule of a link is broken, a memory is asked for what it does not hold, the queue overflows, or nothing moves
//   for settings.watchdog clocks; its text begins with the link that stopped.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "hls/core/packed.hpp"
#include "hls/edge/engine.hpp"
#include "hls/top/top.hpp"

namespace relievo::tb {

// A rule of the bench was broken by the circuit: what, where, and at which clock; model: whose circuit it was.
struct cosim_error : std::runtime_error {
  explicit cosim_error(std::string const& what, char const* model_name = "rtl") : std::runtime_error(what), model(model_name) {}
  char const* model;
};

struct cosim_settings {
  std::string variant = "default";  // one of engine_variants()
  int idle = 0, stall = 0;          // percent of clocks in which sources rest, sinks and memories refuse
  int latency_low = 1, latency_high = 1;
  bool bursty = false;
  std::uint64_t seed = 1;
  int reset_seed = 1;              // what registers hold before reset
  std::uint64_t watchdog = 20000;  // clocks without a moving word
  // A waveform (waveform.hpp): FILE.fst, or nothing; from this clock of the bench on, so many clocks.
  std::string trace;
  std::uint64_t trace_from = 1, trace_cycles = 10000;

  bool operator==(cosim_settings const& o) const {
    return variant == o.variant && idle == o.idle && stall == o.stall && latency_low == o.latency_low && latency_high == o.latency_high &&
           bursty == o.bursty && seed == o.seed && reset_seed == o.reset_seed && watchdog == o.watchdog && trace == o.trace &&
           trace_from == o.trace_from && trace_cycles == o.trace_cycles;
  }
};

// What one mesh needs; all of it outlives the run.
struct cosim_scene {
  hls::engine_regs regs;
  std::vector<hls::port_word<hls::top::base_triangle>> const* triangles;
  hls::engine_memories memories;
};

struct link_report {
  std::string name;
  std::uint64_t moved, waited, idle;
  // Answers of a memory: how many were awaited, on average and at most.
  bool answers;
  double in_flight;
  std::uint64_t most_in_flight;
};

struct cosim_result {
  std::vector<std::uint64_t> counters;  // in the order of hls/edge/counters.hpp
  std::uint64_t clocks = 0;             // from start to the last word out
  std::vector<link_report> links;
};

class engine_bench {
 public:
  virtual ~engine_bench() = default;
  // out: every record that leaves, the empty one too. abort_after: so many clocks after the start a reset ends the run (0: never), and
  // what came out until then is all there is.
  virtual cosim_result run(cosim_scene const& scene, std::function<void(hls::triangle_out const&)> const& out, bool reset = true,
                           std::uint64_t abort_after = 0) = 0;
};

using engine_factory = std::function<std::unique_ptr<engine_bench>(cosim_settings const&)>;

// The bench of this process; std::logic_error when it was made with other settings.
engine_bench& the_engine_bench(cosim_settings const& settings);

// Engines with other build parameters: each source file that has one adds it under a name (engine_bench_of.hpp).
bool add_engine_variant(std::string const& name, engine_factory const& make);
std::vector<std::string> engine_variants();
void add_default_engine();

}  // namespace relievo::tb
