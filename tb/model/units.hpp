// units: the units without a memory, by name, as functions from raw words to raw words, in hls and in golden. What replay runs, and a
// place to hold any other implementation against.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tb/model/words.hpp"

namespace relievo::tb {

struct pure_unit {
  using words = std::vector<std::int64_t>;
  std::string name;
  std::vector<field> in, regs, out;
  std::function<words(words const&in, words const&regs)> hls, golden;
};

std::vector<pure_unit> const& pure_units();
pure_unit const* find_unit(std::string const& name);

}  // namespace relievo::tb
