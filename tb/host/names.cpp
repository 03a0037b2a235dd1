#include "tb/host/names.hpp"

#include <charconv>

#include "tb/host/input_error.hpp"

namespace relievo::tb {

std::optional<std::vector<int>> numbers_of(std::string const& spec, std::string const& name, std::size_t most) {
  if (spec == name) return std::vector<int>{};
  if (spec.compare(0, name.size() + 1, name + ":") != 0) return std::nullopt;
  std::vector<int> numbers;
  char const* at = spec.data() + name.size() + 1;
  char const* const end = spec.data() + spec.size();
  while (true) {
    int value = 0;
    const auto [rest, failed] = std::from_chars(at, end, value);
    if (failed != std::errc() || value < 1 || value > 100000 || numbers.size() == most || (rest != end && *rest != ','))
      throw input_error(spec + ": after the name come " + (most == 0 ? std::string("no numbers") : "up to " + std::to_string(most)) +
                        (most == 0 ? "" : " whole numbers, from 1 to 100000, separated by commas"));
    numbers.push_back(value);
    if (rest == end) return numbers;
    at = rest + 1;
  }
}

}  // namespace relievo::tb
