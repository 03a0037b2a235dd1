#include "tb/cosim/edge_engine_driver.hpp"

#include <cstddef>

// Made of rtl/top/edge_engine.rdl by scripts/registers.sh.
#include "edge_engine_registers.h"

namespace relievo::tb {

namespace {

// Address and size of a register, by its name.
#define RELIEVO_REGISTER(name) offsetof(edge_engine_t, name), sizeof(static_cast<edge_engine_t*>(nullptr)->name)
// A field of a record, an element of an array in one: element i is the register name_i.
#define RELIEVO_PUT(record, name) put(RELIEVO_REGISTER(record.name), regs.name)
#define RELIEVO_PUT_3(record, name)                     \
  put(RELIEVO_REGISTER(record.name##_0), regs.name[0]); \
  put(RELIEVO_REGISTER(record.name##_1), regs.name[1]); \
  put(RELIEVO_REGISTER(record.name##_2), regs.name[2])
#define RELIEVO_PUT_3_OF(record, name, i)                        \
  put(RELIEVO_REGISTER(record.name##_##i##_0), regs.name[i][0]); \
  put(RELIEVO_REGISTER(record.name##_##i##_1), regs.name[i][1]); \
  put(RELIEVO_REGISTER(record.name##_##i##_2), regs.name[i][2])
#define RELIEVO_COUNT(name) c.name = read(RELIEVO_REGISTER(counters.name))

// The codes are the register map's.
#define RELIEVO_CODE(name)                                                                               \
  static_assert(static_cast<int>(edge_engine_code::name) == static_cast<int>(edge_engine_error__##name), \
                "edge_engine.rdl and edge_engine_driver.hpp number " #name " differently")
RELIEVO_CODE(none);
RELIEVO_CODE(map_size_zero);
RELIEVO_CODE(map_size_too_large);
RELIEVO_CODE(max_generation_too_large);
RELIEVO_CODE(early_last);
RELIEVO_CODE(missing_last);
RELIEVO_CODE(last_disagrees);
RELIEVO_CODE(coordinate_outside_map);
RELIEVO_CODE(start_while_busy);
RELIEVO_CODE(queue_overflow);
RELIEVO_CODE(map_early_last);
RELIEVO_CODE(map_missing_last);
RELIEVO_CODE(stopped);
RELIEVO_CODE(memory_error);
#undef RELIEVO_CODE

}  // namespace

std::uint64_t edge_engine_driver::read(std::size_t address, std::size_t bytes) {
  const auto at = static_cast<std::uint32_t>(address);
  const std::uint64_t low = bus_.read32(at);
  return bytes == 4 ? low : low | static_cast<std::uint64_t>(bus_.read32(at + 4)) << 32;
}

void edge_engine_driver::write(std::size_t address, std::size_t bytes, std::int64_t word) {
  const auto at = static_cast<std::uint32_t>(address);
  const auto bits = static_cast<std::uint64_t>(word);
  bus_.write32(at, static_cast<std::uint32_t>(bits & 0xffffffffu));
  if (bytes == 8) bus_.write32(at + 4, static_cast<std::uint32_t>(bits >> 32));
}

edge_engine_build edge_engine_driver::build() {
  const auto word = [&](std::size_t address, std::size_t bytes) { return static_cast<std::uint32_t>(read(address, bytes)); };
  return {word(RELIEVO_REGISTER(build_lanes)), word(RELIEVO_REGISTER(build_sat_reads_per_clock)),
          word(RELIEVO_REGISTER(build_profile_samples_per_clock)), word(RELIEVO_REGISTER(build_queue_depth)),
          word(RELIEVO_REGISTER(build_max_generation))};
}

void edge_engine_driver::set(hls::engine_regs const& regs) {
  RELIEVO_PUT(engine_regs, map.width);
  RELIEVO_PUT(engine_regs, map.height);
  RELIEVO_PUT(engine_regs, map.wrap_u);
  RELIEVO_PUT(engine_regs, map.wrap_v);
  RELIEVO_PUT(engine_regs, displace.scale);
  RELIEVO_PUT(engine_regs, displace.bias);
  RELIEVO_PUT_3(engine_regs, transform.row_x);
  RELIEVO_PUT_3(engine_regs, transform.row_y);
  RELIEVO_PUT_3(engine_regs, transform.row_w);
  RELIEVO_PUT(engine_regs, transform.offset_x);
  RELIEVO_PUT(engine_regs, transform.offset_y);
  RELIEVO_PUT(engine_regs, transform.offset_w);
  RELIEVO_PUT(engine_regs, transform.w_min);
  RELIEVO_PUT_3_OF(engine_regs, transform_normal.rotation, 0);
  RELIEVO_PUT_3_OF(engine_regs, transform_normal.rotation, 1);
  RELIEVO_PUT_3_OF(engine_regs, transform_normal.rotation, 2);
  RELIEVO_PUT_3(engine_regs, transform_normal.eye);
  RELIEVO_PUT(engine_regs, normal.threshold);
  RELIEVO_PUT(engine_regs, summed_height.average);
  RELIEVO_PUT(engine_regs, summed_height.sum_threshold);
  RELIEVO_PUT(engine_regs, summed_height.average_threshold);
  RELIEVO_PUT(engine_regs, view.threshold);
  RELIEVO_PUT_3(engine_regs, highlight.half_vector);
  RELIEVO_PUT(engine_regs, highlight.threshold);
  RELIEVO_PUT(engine_regs, profile.threshold);
  RELIEVO_PUT(engine_regs, pass.use_nt);
  RELIEVO_PUT(engine_regs, pass.use_sht);
  RELIEVO_PUT(engine_regs, pass.use_pt);
  RELIEVO_PUT(engine_regs, pass.use_ht);
  RELIEVO_PUT(engine_regs, pass.use_vt);
  RELIEVO_PUT(engine_regs, pass.use_ct);
  RELIEVO_PUT(engine_regs, pass.max_generation);
  RELIEVO_PUT(engine_regs, pass.cull);
  RELIEVO_PUT(engine_regs, queue.fifo);
}

void edge_engine_driver::set(hls::normal_map_regs const& regs) {
  RELIEVO_PUT(normal_map_regs, gradient_u);
  RELIEVO_PUT(normal_map_regs, gradient_v);
  RELIEVO_PUT(normal_map_regs, normal_shift);
}

void edge_engine_driver::start(std::uint32_t expected_triangles) {
  write(RELIEVO_REGISTER(expected_triangles), expected_triangles);
  write(RELIEVO_REGISTER(control), EDGE_ENGINE__CONTROL__START_bm);
}
void edge_engine_driver::stop() { write(RELIEVO_REGISTER(control), EDGE_ENGINE__CONTROL__STOP_bm); }
void edge_engine_driver::clear_error() { write(RELIEVO_REGISTER(control), EDGE_ENGINE__CONTROL__CLEAR_ERROR_bm); }

edge_engine_state edge_engine_driver::state() {
  const auto word = static_cast<std::uint32_t>(read(RELIEVO_REGISTER(state)));
  const auto bit = [&](std::uint32_t mask) { return (word & mask) != 0; };
  const std::uint32_t code = (word & EDGE_ENGINE__STATE__ERROR_CODE_bm) >> EDGE_ENGINE__STATE__ERROR_CODE_bp;
  return {bit(EDGE_ENGINE__STATE__BUSY_bm),       bit(EDGE_ENGINE__STATE__DONE_bm),     bit(EDGE_ENGINE__STATE__ERROR_bm),
          bit(EDGE_ENGINE__STATE__SWALLOWING_bm), bit(EDGE_ENGINE__STATE__MAP_BUSY_bm), static_cast<edge_engine_code>(code)};
}

edge_engine_state edge_engine_driver::wait(std::uint64_t polls) {
  for (std::uint64_t i = 0; i < polls; ++i) {
    const edge_engine_state s = state();
    if (!s.busy || (s.error && is_refusal(s.code))) return s;
  }
  give_up(polls);
}

edge_engine_state edge_engine_driver::drain(std::uint64_t polls) {
  for (std::uint64_t i = 0; i < polls; ++i) {
    const edge_engine_state s = state();
    if (!s.busy) return s;
  }
  give_up(polls);
}

void edge_engine_driver::give_up(std::uint64_t polls) {
  check(state());
  throw edge_engine_error("edge engine: the mesh is not done after " + std::to_string(polls) +
                          " reads of its state; does its packet have an end, and does someone take what comes out? stop() ends it");
}

hls::counters edge_engine_driver::counters() {
  hls::counters c;
  RELIEVO_COUNT(triangles_in);
  RELIEVO_COUNT(triangles_out);
  RELIEVO_COUNT(culled);
  RELIEVO_COUNT(edge_tests);
  RELIEVO_COUNT(settled_skips);
  RELIEVO_COUNT(vt);
  RELIEVO_COUNT(ct);
  RELIEVO_COUNT(nt);
  RELIEVO_COUNT(sht);
  RELIEVO_COUNT(pt);
  RELIEVO_COUNT(ht);
  c.splits[0] = read(RELIEVO_REGISTER(counters.splits_0));
  c.splits[1] = read(RELIEVO_REGISTER(counters.splits_1));
  c.splits[2] = read(RELIEVO_REGISTER(counters.splits_2));
  c.splits[3] = read(RELIEVO_REGISTER(counters.splits_3));
  RELIEVO_COUNT(vertices);
  RELIEVO_COUNT(queue_high_water);
  RELIEVO_COUNT(fifo_fallbacks);
  RELIEVO_COUNT(saturations);
  RELIEVO_COUNT(screen_saturations);
  RELIEVO_COUNT(zero_vectors);
  RELIEVO_COUNT(table_reads);
  RELIEVO_COUNT(profile_samples);
  return c;
}

std::uint32_t edge_engine_driver::normal_saturations() { return static_cast<std::uint32_t>(read(RELIEVO_REGISTER(normal_saturations))); }

std::string edge_engine_driver::describe(edge_engine_code code) {
  const auto value = [&](std::size_t address, std::size_t bytes) { return std::to_string(read(address, bytes)); };
  const auto size = [&] {
    return value(RELIEVO_REGISTER(engine_regs.map.width)) + " x " + value(RELIEVO_REGISTER(engine_regs.map.height));
  };
  const auto expected = [&] { return value(RELIEVO_REGISTER(expected_triangles)); };
  const auto came = [&] { return value(RELIEVO_REGISTER(counters.triangles_in)); };
  switch (code) {
    case edge_engine_code::none:
      return "edge engine: no error";
    case edge_engine_code::map_size_zero:
    case edge_engine_code::map_size_too_large:
      return "edge engine: map.width x map.height are " + size() + ", where 1..8192 each are right";
    case edge_engine_code::max_generation_too_large:
      return "edge engine: pass.max_generation is " + value(RELIEVO_REGISTER(engine_regs.pass.max_generation)) + ", where this build has " +
             value(RELIEVO_REGISTER(build_max_generation)) + " at most";
    case edge_engine_code::early_last:
      return "edge engine: the last base triangle came after " + came() + ", where expected_triangles is " + expected();
    case edge_engine_code::missing_last:
      return "edge engine: base triangle " + expected() + " of " + expected() + " came without last and tlast";
    case edge_engine_code::last_disagrees:
      return "edge engine: base triangle " + came() + " has only one of last and tlast, where both mark the end of a mesh";
    case edge_engine_code::coordinate_outside_map:
      return "edge engine: the base triangle after " + came() + " has a texture coordinate outside the map of " + size() +
             " texels: up to size - 1 where an axis clamps, size where it wraps";
    case edge_engine_code::start_while_busy:
      return "edge engine: start was written while a mesh was running; it was ignored";
    case edge_engine_code::queue_overflow:
      return "edge engine: the triangle queue overflowed, which its circuit excludes: triangles are missing";
    case edge_engine_code::map_early_last:
      return "edge engine: tlast came before the last texel of a map of " + size();
    case edge_engine_code::map_missing_last:
      return "edge engine: the last texel of a map of " + size() + " came without tlast";
    case edge_engine_code::stopped:
      return "edge engine: stop was written before the packet was over";
    case edge_engine_code::memory_error:
      return "edge engine: a map memory answered a read with an error, where every word of the maps must be readable";
  }
  return "edge engine: error code " + std::to_string(static_cast<int>(code)) + ", which this driver does not know";
}

void edge_engine_driver::check(edge_engine_state const& s) {
  if (s.error) throw edge_engine_error(describe(s.code));
}

#undef RELIEVO_REGISTER
#undef RELIEVO_PUT
#undef RELIEVO_PUT_3
#undef RELIEVO_PUT_3_OF
#undef RELIEVO_COUNT

}  // namespace relievo::tb
