#include "tb/host/scene_options.hpp"

#include <charconv>
#include <cmath>
#include <vector>

#include "tb/host/input_error.hpp"

namespace relievo::tb {

namespace {

std::vector<std::string> parts_of(std::string const& text, char separator) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  while (true) {
    const std::size_t to = text.find(separator, from);
    parts.push_back(text.substr(from, to - from));
    if (to == std::string::npos) return parts;
    from = to + 1;
  }
}

// Whole numbers or doubles, as many as `count`; `form` says in the message how the option is written.
template <class T>
std::vector<T> numbers_in(std::string const& text, char separator, std::size_t count, std::string const& option, std::string const& form) {
  std::vector<T> numbers;
  for (std::string const& part : parts_of(text, separator)) {
    T value{};
    char const* begin = part.data() + (!part.empty() && part.front() == '+' ? 1 : 0);
    char const* const end = part.data() + part.size();
    const auto [rest, failed] = std::from_chars(begin, end, value);
    if (failed != std::errc() || rest != end || !std::isfinite(static_cast<double>(value)))
      throw input_error(option + ": '" + text + "': '" + part + "' is not a finite number; the form is " + form);
    numbers.push_back(value);
  }
  if (numbers.size() != count) throw input_error(option + ": '" + text + "': " + std::to_string(count) + " numbers are needed: " + form);
  return numbers;
}

}  // namespace

engine_kind parse_engine(std::string const& text, std::string const& option) {
  if (text != "edge" && text != "sweep") throw input_error(option + ": '" + text + "' is no engine here; known are edge, sweep");
  return text == "sweep" ? engine_kind::sweep : engine_kind::edge;
}

test_selection parse_tests(std::string const& text, std::string const& option) {
  test_selection tests{false, false, false, false, false, false};
  if (text == "none") return tests;
  for (std::string const& part : parts_of(text, ',')) {
    bool* const flag = part == "nt"    ? &tests.nt
                       : part == "sht" ? &tests.sht
                       : part == "pt"  ? &tests.pt
                       : part == "ht"  ? &tests.ht
                       : part == "vt"  ? &tests.vt
                       : part == "ct"  ? &tests.ct
                                       : nullptr;
    if (flag == nullptr) throw input_error(option + ": '" + part + "' is no test; a list of nt, sht, pt, ht, vt, ct, or none, is needed");
    *flag = true;
  }
  return tests;
}

std::array<bool, 2> parse_address(std::string const& text, std::string const& option) {
  const std::vector<std::string> parts = parts_of(text, ',');
  const auto wraps = [&](std::string const& part) {
    if (part != "clamp" && part != "wrap") throw input_error(option + ": '" + part + "' is none of clamp, wrap; one for both axes or u,v");
    return part == "wrap";
  };
  if (parts.size() > 2) throw input_error(option + ": '" + text + "': one of clamp, wrap for both axes, or two as u,v, is needed");
  return {wraps(parts.front()), wraps(parts.back())};
}

glm::dvec3 parse_vector3(std::string const& text, std::string const& option) {
  const auto n = numbers_in<double>(text, ',', 3, option, "x,y,z");
  return {n[0], n[1], n[2]};
}

glm::dvec2 parse_vector2(std::string const& text, std::string const& option) {
  const auto n = numbers_in<double>(text, ',', 2, option, "a,b");
  return {n[0], n[1]};
}

std::array<int, 2> parse_viewport(std::string const& text, std::string const& option) {
  const auto n = numbers_in<int>(text, 'x', 2, option, "WIDTHxHEIGHT");
  return {n[0], n[1]};
}

sample_range parse_sample_range(std::string const& text, std::string const& option) {
  const auto n = numbers_in<double>(text, ',', 2, option, "LO,HI");
  if (n[0] == n[1]) throw input_error(option + ": '" + text + "': two different numbers are needed");
  return {n[0], n[1]};
}

bool parse_height_mode(std::string const& text, std::string const& option) {
  if (text != "sum" && text != "average") throw input_error(option + ": '" + text + "' is none of sum, average");
  return text == "average";
}

bool parse_queue(std::string const& text, std::string const& option) {
  if (text != "lifo" && text != "fifo") throw input_error(option + ": '" + text + "' is none of lifo, fifo");
  return text == "fifo";
}

}  // namespace relievo::tb
