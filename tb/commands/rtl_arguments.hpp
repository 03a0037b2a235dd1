// rtl_arguments: how the bench of the circuit runs: --stall, --idle, --latency, --bursty, --seed, --watchdog, --trace; for commands
// with --model rtl.
#pragma once
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "tb/cosim/engine_bench.hpp"

namespace relievo::tb {

class rtl_arguments {
 public:
  // with_seed: false where the command has a --seed of its own, which set_seed hands on.
  void add_to(CLI::App& app, bool with_seed = true);
  void set_seed(std::uint64_t seed) { settings_.seed = seed; }
  // Hands the options to the bench; input_error names what is wrong. circuit: whether the command runs one.
  void apply(bool circuit) const;

 private:
  cosim_settings settings_;
  void check_trace(cosim_settings& s, bool circuit) const;
  std::optional<std::string> latency_, trace_;
  std::optional<std::int64_t> trace_from_, trace_cycles_;
};

// Clocks of the last run of the circuit, an edge test and an output triangle, and where its links waited: rows on stdout, and the report's
// part.
void print_cosim(std::uint64_t edge_tests, std::uint64_t triangles);
nlohmann::json cosim_to_json(std::uint64_t edge_tests);

}  // namespace relievo::tb
