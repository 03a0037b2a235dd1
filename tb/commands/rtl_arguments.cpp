#include "tb/commands/rtl_arguments.hpp"

#include <algorithm>
#include <cstdio>

#include "tb/commands/reporting.hpp"
#include "tb/cosim/limited_by.hpp"
#include "tb/cosim/rtl_model.hpp"
#include "tb/cosim/top_model.hpp"
#include "tb/cosim/waveform.hpp"
#include "tb/host/files.hpp"
#include "tb/host/input_error.hpp"

namespace relievo::tb {

void rtl_arguments::add_to(CLI::App& app, bool with_seed) {
  app.add_option("--stall", settings_.stall, "rtl, top: percent of clocks in which sinks and memories refuse a word, 0..99")
      ->group("Circuit")
      ->capture_default_str();
  app.add_option("--idle", settings_.idle, "rtl, top: percent of clocks in which the source rests, 0..99")
      ->group("Circuit")
      ->capture_default_str();
  app.add_option("--latency", latency_, "rtl, top: N|LO-HI clocks of the memories, 1..10000; default 1")->group("Circuit");
  app.add_flag("--bursty", settings_.bursty, "rtl, top: the memories answer in bursts")->group("Circuit");
  if (with_seed)
    app.add_option("--seed", settings_.seed, "rtl, top: of stalls, latencies and what registers hold before reset")
        ->group("Circuit")
        ->capture_default_str();
  app.add_option("--watchdog", settings_.watchdog, "rtl, top: clocks without a moving word that end the run")
      ->group("Circuit")
      ->capture_default_str();
  app.add_option("--trace", trace_, "rtl: FILE.fst, a waveform, and FILE.gtkw, which shows it in GTKWave")->group("Circuit");
  app.add_option("--trace-from", trace_from_, "rtl: first clock of the waveform, counted from the reset; default 1")->group("Circuit");
  app.add_option("--trace-cycles", trace_cycles_, "rtl: clocks of the waveform; default 10000")->group("Circuit");
}

void rtl_arguments::check_trace(cosim_settings& s, std::vector<std::string> const& models) const {
  const auto clocks = [&](char const* option, std::optional<std::int64_t> const& given, std::uint64_t& to) {
    if (!given) return;
    if (!trace_) throw input_error(std::string(option) + ": belongs to a waveform; name its file with --trace FILE.fst");
    if (*given < 1) throw input_error(std::string(option) + ": " + std::to_string(*given) + " is no count of clocks from 1 on");
    to = static_cast<std::uint64_t>(*given);
  };
  clocks("--trace-from", trace_from_, s.trace_from);
  clocks("--trace-cycles", trace_cycles_, s.trace_cycles);
  if (!trace_) return;
  if (std::find(models.begin(), models.end(), "rtl") == models.end())
    throw input_error("--trace: only the circuit in its SystemC bench has a waveform; take the model rtl");
  if (extension_of(*trace_) != "fst") throw input_error("--trace: '" + *trace_ + "' does not end in .fst");
  check_writable(*trace_);
  check_writable(gtkwave_name(*trace_));
  s.trace = *trace_;
}

void rtl_arguments::apply(std::vector<std::string> const& models) const {
  cosim_settings s = settings_;
  const auto percent = [](char const* option, int value) {
    if (value < 0 || value > 99) throw input_error(std::string(option) + ": " + std::to_string(value) + " is not within 0..99 percent");
  };
  percent("--stall", s.stall);
  percent("--idle", s.idle);
  if (latency_) {
    int low = 0, high = 0, end = 0;
    const int fields = std::sscanf(latency_->c_str(), "%5d%n-%5d%n", &low, &end, &high, &end);
    if (fields < 2) high = low;
    if (fields < 1 || latency_->size() != static_cast<std::size_t>(end) || low < 1 || high < low || high > 10000)
      throw input_error("--latency: '" + *latency_ + "' is not a number of clocks or LO-HI within 1..10000");
    s.latency_low = low;
    s.latency_high = high;
  }
  check_trace(s, models);
  s.reset_seed = static_cast<int>(s.seed & 0x7fffffff) + 1;
  set_cosim_settings(s);
  set_top_settings(s);
}

namespace {

double per(std::uint64_t clocks, std::uint64_t n) { return n == 0 ? 0.0 : static_cast<double>(clocks) / static_cast<double>(n); }

void print_clocks(std::uint64_t clocks, std::uint64_t edge_tests, std::uint64_t triangles) {
  char text[120];
  std::snprintf(text, sizeof text, "%s, %.3f an edge test, %.3f a triangle", grouped(clocks).c_str(), per(clocks, edge_tests),
                per(clocks, triangles));
  print_row("clocks", text);
}

void print_rtl(std::uint64_t edge_tests, std::uint64_t triangles) {
  cosim_result const& r = last_cosim_result();
  print_clocks(r.clocks, edge_tests, triangles);
  char text[120];
  for (link_report const& l : r.links)
    if (l.waited != 0) print_row("  waited", l.name + ": " + grouped(l.waited) + " clocks");
  for (link_report const& l : r.links)
    if (l.answers && l.moved != 0) {
      std::snprintf(text, sizeof text, "%s: in %.0f %% of the clocks", l.name.c_str(), 100 * busy(l));
      std::string row = text;
      std::snprintf(text, sizeof text, ", %.0f awaited on average, %llu at most", l.in_flight,
                    static_cast<unsigned long long>(l.most_in_flight));
      if (l.most_in_flight != 0) row += text;
      print_row("  memory", row);
    }
  print_row("  limited by", limited_by(r));
}

nlohmann::json rtl_to_json(std::uint64_t edge_tests) {
  cosim_result const& r = last_cosim_result();
  std::uint64_t stalls = 0;
  nlohmann::json links, memories;
  for (link_report const& l : r.links) {
    stalls += l.waited;
    links[l.name] = {{"moved", l.moved}, {"waited", l.waited}, {"idle", l.idle}};
    if (l.answers) memories[l.name] = {{"reads", l.moved}, {"in_flight", l.in_flight}, {"most_in_flight", l.most_in_flight}};
  }
  return {{"cycles", r.clocks},          {"cycles_per_edge_test", per(r.clocks, edge_tests)},
          {"stall_cycles", stalls},      {"memory_reads", memories},
          {"limited_by", limited_by(r)}, {"links", links}};
}

void print_top(std::uint64_t edge_tests, std::uint64_t triangles) {
  top_result const& r = last_top_result();
  edge_engine_build const& b = r.build;
  print_row("built with", std::to_string(b.lanes) + (b.lanes == 1 ? " lane, " : " lanes, ") + std::to_string(b.sat_reads_per_clock) +
                              " table reads and " + std::to_string(b.profile_samples_per_clock) + " profile samples a clock, queue of " +
                              grouped(b.queue_depth) + ", max_generation " + std::to_string(b.max_generation));
  print_clocks(r.clocks, edge_tests, triangles);
  print_row("  maps", grouped(r.map_clocks) + " clocks to build both");
}

nlohmann::json top_to_json(std::uint64_t edge_tests) {
  top_result const& r = last_top_result();
  edge_engine_build const& b = r.build;
  return {{"cycles", r.clocks},
          {"cycles_per_edge_test", per(r.clocks, edge_tests)},
          {"map_cycles", r.map_clocks},
          {"build",
           {{"lanes", b.lanes},
            {"sat_reads_per_clock", b.sat_reads_per_clock},
            {"profile_samples_per_clock", b.profile_samples_per_clock},
            {"queue_depth", b.queue_depth},
            {"max_generation", b.max_generation}}}};
}

}  // namespace

void print_circuit(std::string const& model, std::uint64_t edge_tests, std::uint64_t triangles) {
  if (model == "rtl") print_rtl(edge_tests, triangles);
  if (model == "top") print_top(edge_tests, triangles);
}

void report_circuit(nlohmann::json& report, std::string const& model, std::uint64_t edge_tests) {
  if (model == "rtl") report[model] = rtl_to_json(edge_tests);
  if (model == "top") report[model] = top_to_json(edge_tests);
}

}  // namespace relievo::tb
