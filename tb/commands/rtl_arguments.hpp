// rtl_arguments: how the benches of the circuit run: --stall, --idle, --latency, --bursty, --seed, --watchdog, --trace; for commands
// with --model rtl or top; and what these models report besides their counters.
#pragma once
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tb/cosim/engine_bench.hpp"

namespace relievo::tb {

class rtl_arguments {
 public:
  // with_seed: false where the command has a --seed of its own, which set_seed hands on.
  void add_to(CLI::App& app, bool with_seed = true);
  void set_seed(std::uint64_t seed) { settings_.seed = seed; }
  // Hands the options to the benches; input_error names what is wrong. models: those that the command runs.
  void apply(std::vector<std::string> const& models) const;

 private:
  cosim_settings settings_;
  void check_trace(cosim_settings& s, std::vector<std::string> const& models) const;
  std::optional<std::string> latency_, trace_;
  std::optional<std::int64_t> trace_from_, trace_cycles_;
};

// Where `model` is a circuit's: clocks of its last run, an edge test and an output triangle, and where its links waited (rtl) or what it
// was built with (top): rows on stdout, and the report's part under the model's name.
void print_circuit(std::string const& model, std::uint64_t edge_tests, std::uint64_t triangles);
void report_circuit(nlohmann::json& report, std::string const& model, std::uint64_t edge_tests);

}  // namespace relievo::tb
