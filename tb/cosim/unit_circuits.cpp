#include "tb/cosim/unit_circuits.hpp"

#include <map>
#include <stdexcept>

namespace relievo::tb {

namespace {
std::map<std::string, unit_circuit>& circuits() {
  static std::map<std::string, unit_circuit> all;
  return all;
}
}  // namespace

void add_unit_circuit(std::string const& unit, unit_circuit const& circuit) { circuits()[unit] = circuit; }

unit_circuit const* find_unit_circuit(std::string const& unit) {
  const auto found = circuits().find(unit);
  return found == circuits().end() ? nullptr : &found->second;
}

int packed_width(std::vector<field> const& fields) {
  int width = 0;
  for (field const& f : fields) width += f.width;
  if (width > widest_record) throw std::logic_error("a record of " + std::to_string(width) + " bits is wider than widest_record");
  return width;
}

hls::bits<widest_record> packed(unit_words const& words, std::vector<field> const& fields) {
  hls::bits<widest_record> word{};
  int at = 0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const int width = fields[i].width;
    const auto value = static_cast<std::uint64_t>(words[i]) & (~std::uint64_t(0) >> (64 - width));
    word.limb[at / 64] |= value << (at % 64);
    if (at % 64 + width > 64) word.limb[at / 64 + 1] |= value >> (64 - at % 64);
    at += width;
  }
  return word;
}

unit_words unpacked(hls::bits<widest_record> const& word, std::vector<field> const& fields) {
  unit_words words;
  int at = 0;
  for (field const& f : fields) {
    std::uint64_t value = word.limb[at / 64] >> (at % 64);
    if (at % 64 + f.width > 64) value |= word.limb[at / 64 + 1] << (64 - at % 64);
    const int unused = 64 - f.width;
    value <<= unused;
    words.push_back(f.is_signed ? static_cast<std::int64_t>(value) >> unused : static_cast<std::int64_t>(value >> unused));
    at += f.width;
  }
  return words;
}

}  // namespace relievo::tb
