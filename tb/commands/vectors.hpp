// vectors: recorded words, to be run again through any model: a header of lines "key value", then a record a line in hex.
//
//   relievo-vectors 1
//   unit NAME            a unit of tb/model/units.hpp, or engine
//   formats HASH         of the format table they were recorded with: another table cannot run them
//   seed N
//   order free           engine, only where the outputs are not in golden's order: the circuit's
//   regs WORDS           one line; for the engine then: normal_map WORDS, and a texels line per row of the map from v = 0
//   i WORDS / o WORDS    inputs and expected outputs in order; a unit has one o after each i, the engine all i, then all o
//
// Words are two's complement in the width of their format, in the order of tb::layout.
// Errors: input_error with file, line and what would be right.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tb/model/model.hpp"
#include "tb/model/units.hpp"

namespace relievo::tb {

struct unit_vectors {
  using words = std::vector<std::int64_t>;
  std::string unit;
  std::uint64_t seed = 0;
  bool in_order = true;
  words regs, normal_map;
  std::vector<words> texels;  // engine: rows of the map
  std::vector<words> in, out;
};

std::uint64_t format_hash();

std::string to_text(unit_vectors const& v);
unit_vectors parse_vectors(std::string_view text, std::string const& name);

// `count` random records of a unit (corners first), with golden's outputs.
unit_vectors record_unit(pure_unit const& unit, std::size_t count, std::uint64_t seed);

// A whole scene and its output.
void write_engine_vectors(std::string const& path, scene const& sc, run_result const& run);
// The scene that engine vectors hold: registers, map and base triangles; nothing for people.
scene scene_of(unit_vectors const& v, std::string const& name);
// And the output that they hold, without counters.
run_result run_of(unit_vectors const& v);

}  // namespace relievo::tb
