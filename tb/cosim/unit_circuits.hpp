// unit_circuits: the circuits of units without a memory, by the names of tb/model/units.hpp, as functions from raw words to raw words. A
// program that brings some says add_unit_circuit(); the command line itself has none (each is a model to compile), relievo_units_rtl all.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "hls/core/packed.hpp"
#include "tb/model/units.hpp"

namespace relievo::tb {

using unit_words = std::vector<std::int64_t>;
// (records in, registers) -> records out, in order
using unit_circuit = std::function<std::vector<unit_words>(std::vector<unit_words> const& in, unit_words const& regs)>;

void add_unit_circuit(std::string const& unit, unit_circuit const& circuit);
unit_circuit const* find_unit_circuit(std::string const& unit);

// Words of a record packed as hls/core/packed.hpp has them, and back.
constexpr int widest_record = 512;
hls::bits<widest_record> packed(unit_words const& words, std::vector<field> const& fields);
unit_words unpacked(hls::bits<widest_record> const& word, std::vector<field> const& fields);
int packed_width(std::vector<field> const& fields);

}  // namespace relievo::tb
