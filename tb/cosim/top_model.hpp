// top_model: the edge engine among its buses (rtl/top/edge_engine.sv) as a model among the others, run as a host would: registers are
// written over AXI4-Lite, the map is streamed in for the circuit's builders, base triangles go in and triangles come out by AXI4-Stream,
// and the counters are read from the registers.
//
//   add_top_model()          makes "top" one of the models of this program; it builds its maps when it is made, and runs any number of
//   meshes make_top_model(sc, change)   one whose host does something else than the scene needs: change(job) before anything is written
//   Errors: edge_engine_error, an input_error, when the engine's state register has an error code; cosim_error when a rule of a bus is
//   broken or no word moves for settings.watchdog clocks, and then begins with the link that stopped.
#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "hls/top/top.hpp"
#include "tb/cosim/bus_traffic.hpp"
#include "tb/cosim/edge_engine_driver.hpp"
#include "tb/cosim/engine_bench.hpp"
#include "tb/model/model.hpp"

namespace relievo::tb {

// What the host does for a scene.
struct host_job {
  hls::engine_regs regs{};
  hls::normal_map_regs normal_regs{};
  std::deque<bus_word<std::uint16_t>> texels;
  std::vector<bus_word<hls::top::base_triangle>> base;
  std::uint32_t expected = 0;                          // base triangles that the start announces
  std::function<void(edge_engine_driver&)> meanwhile;  // what else it does, right after the start
  bool memory_fails = false;                           // a map memory says that it could not answer
};

void add_top_model();
std::unique_ptr<model> make_top_model(scene const& sc, std::function<void(host_job&)> const& change);

// How busy the buses are: idle, stall, latencies, bursty, the seeds and the watchdog of the settings; for models made afterwards.
void set_top_settings(cosim_settings const& settings);

// Of the last run, from the registers and the host's clock.
struct top_result {
  edge_engine_build build{};
  std::uint64_t map_clocks = 0;  // from the first texel offered to the last word of both maps
  std::uint64_t clocks = 0;      // of the mesh, from the write of start to the last triangle
};
top_result const& last_top_result();

}  // namespace relievo::tb
