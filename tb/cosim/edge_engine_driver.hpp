// edge_engine_driver: the edge engine as a host sees it, over nothing but reads and writes of 32-bit registers.
//
//   edge_engine_driver driver(bus)        bus: read32 and write32 at the addresses of rtl/top/edge_engine.rdl
//   driver.set(engine_regs)               for the next mesh, and the next map;  driver.set(normal_map_regs) for the next map
//   driver.start(expected)                begins a mesh of so many base triangles, 0: as many as come until the last
//   driver.wait(polls)                    -> the state once the mesh is done, or at once when it was refused for its registers: busy
//                                         then, with the error's code
//   driver.drain(polls)                   -> the state once nothing is busy any more, a refused mesh's packet swallowed
//   Both throw edge_engine_error after so many reads, with the error's line when there is one.
//   driver.counters()                     of the mesh begun last, when it is done
//   driver.check(state)                   throws edge_engine_error, one clear line, when the state has an error code
//   A mesh refused for its registers (is_refusal(code)) waits for its packet, to swallow it: let it come, or call stop(), then drain().
//   These codes are a map's too: of one that is built while a mesh runs wait() tells at once as well.
#pragma once
#include <cstdint>
#include <string>

#include "hls/edge/counters.hpp"
#include "hls/edge/engine_regs.hpp"
#include "hls/surface/normal_map.hpp"
#include "tb/host/input_error.hpp"

namespace relievo::tb {

class register_bus {
 public:
  virtual ~register_bus() = default;
  virtual std::uint32_t read32(std::uint32_t address) = 0;
  virtual void write32(std::uint32_t address, std::uint32_t word) = 0;
};

// Those of rtl/top/edge_engine.rdl; the driver does not compile when they differ.
enum class edge_engine_code {
  none,
  map_size_zero,
  map_size_too_large,
  max_generation_too_large,
  early_last,
  missing_last,
  last_disagrees,
  coordinate_outside_map,
  start_while_busy,
  queue_overflow,
  map_early_last,
  map_missing_last,
  stopped,
  memory_error
};

// A start that has it begins no mesh.
inline bool is_refusal(edge_engine_code code) {
  return code == edge_engine_code::map_size_zero || code == edge_engine_code::map_size_too_large ||
         code == edge_engine_code::max_generation_too_large;
}

// What the host asked for cannot be done: for the command line it is unusable input.
struct edge_engine_error : input_error {
  using input_error::input_error;
};

struct edge_engine_state {
  bool busy, done, error, swallowing, map_busy;
  edge_engine_code code;
};

// The parameters of the build.
struct edge_engine_build {
  std::uint32_t lanes, sat_reads_per_clock, profile_samples_per_clock, queue_depth, max_generation;
};

class edge_engine_driver {
 public:
  explicit edge_engine_driver(register_bus& bus) : bus_(bus) {}

  edge_engine_build build();
  void set(hls::engine_regs const& regs);
  void set(hls::normal_map_regs const& regs);
  void start(std::uint32_t expected_triangles = 0);
  void stop();
  void clear_error();
  edge_engine_state state();
  edge_engine_state wait(std::uint64_t polls);
  edge_engine_state drain(std::uint64_t polls);
  hls::counters counters();
  std::uint32_t normal_saturations();
  // What the code says, with what the registers hold: one line.
  std::string describe(edge_engine_code code);
  void check(edge_engine_state const& state);

 private:
  [[noreturn]] void give_up(std::uint64_t polls);
  std::uint64_t read(std::size_t address, std::size_t bytes);
  void write(std::size_t address, std::size_t bytes, std::int64_t word);
  template <class T>
  void put(std::size_t address, std::size_t bytes, T const& field) {
    write(address, bytes, static_cast<std::int64_t>(raw(field)));
  }
  void put(std::size_t address, std::size_t bytes, bool field) { write(address, bytes, field ? 1 : 0); }

  register_bus& bus_;
};

}  // namespace relievo::tb
