// read_pgm: a displacement map from a .pgm, binary (P5, 8 or 16 bit) or text (P2). An own reader: stb reads P5 but not 16 bits of it as
// they are, and netpbm's library ends the program at an error.
#include <algorithm>
#include <charconv>

#include "tb/host/input_error.hpp"
#include "tb/host/map.hpp"

namespace relievo::tb {

namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

class pgm_reader {
 public:
  pgm_reader(std::string_view bytes, std::string const& name) : rest_(bytes), name_(name) {}

  displacement_map read() {
    const std::string_view magic = rest_.substr(0, 2);
    if (magic != "P5" && magic != "P2") fail("no .pgm, the first two letters have to be P5 or P2");
    rest_.remove_prefix(2);
    if (rest_.empty() || !(is_blank(rest_.front()) || rest_.front() == '#')) fail("no .pgm, a space has to follow P5 or P2");
    displacement_map map;
    map.name = name_;
    map.width = size("width");
    map.height = size("height");
    maximum_ = number("the largest value");
    if (maximum_ < 1 || maximum_ > 65535) fail("the largest value is " + std::to_string(maximum_) + "; from 1 to 65535 is possible");
    const std::size_t count = static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
    const bool binary = magic == "P5";
    if (binary) check_binary(count);
    if (!binary && count > rest_.size()) fail("the file ends early: " + std::to_string(count) + " samples are needed");
    map.texels.resize(count);
    const auto width = static_cast<std::size_t>(map.width);
    for (std::size_t y = static_cast<std::size_t>(map.height); y-- > 0;)
      for (std::size_t x = 0; x < width; ++x) map.texels[y * width + x] = widened(binary ? next_binary() : number("samples"));
    return map;
  }

 private:
  [[noreturn]] void fail(std::string const& why) const { throw input_error(name_ + ": " + why); }

  // Spaces and comments, which run from # to the end of the line.
  void skip() {
    while (!rest_.empty()) {
      if (rest_.front() == '#') {
        const std::size_t end = rest_.find_first_of("\r\n");
        rest_.remove_prefix(std::min(end, rest_.size()));
      } else if (is_blank(rest_.front())) {
        rest_.remove_prefix(1);
      } else {
        return;
      }
    }
  }

  int number(std::string const& what) {
    skip();
    int value = 0;
    const auto [end, failed] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (rest_.empty()) fail(what + ": the file ends early");
    if (failed != std::errc() || value < 0) fail(what + ": is not a number, or too large");
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  int size(std::string const& what) {
    const int value = number(what);
    if (value < 1 || value > max_map_size)
      fail(what + " is " + std::to_string(value) + "; from 1 to " + std::to_string(max_map_size) + " is possible");
    return value;
  }

  // In proportion, so that the largest value becomes 65535: * 257 for 8 bits.
  std::uint16_t widened(int value) const {
    if (value > maximum_) fail("a sample is " + std::to_string(value) + ", above the largest value " + std::to_string(maximum_));
    return static_cast<std::uint16_t>((static_cast<std::int64_t>(value) * 65535 * 2 + maximum_) / (2 * maximum_));
  }

  void check_binary(std::size_t count) {
    if (rest_.empty() || !is_blank(rest_.front())) fail("one space has to follow the largest value");
    rest_.remove_prefix(1);
    const std::size_t each = maximum_ > 255 ? 2 : 1;
    if (each == 2 && rest_.size() == count)
      fail("holds one byte a sample where the largest value, " + std::to_string(maximum_) + ", needs two");
    if (rest_.size() < count * each)
      fail("the file ends early: " + std::to_string(count * each) + " bytes of samples are needed, " + std::to_string(rest_.size()) +
           " are there");
  }

  int next_binary() {
    const auto byte = [&](std::size_t k) { return static_cast<int>(static_cast<unsigned char>(rest_[k])); };
    const int value = maximum_ > 255 ? byte(0) << 8 | byte(1) : byte(0);
    rest_.remove_prefix(maximum_ > 255 ? 2 : 1);
    return value;
  }

  std::string_view rest_;
  std::string const& name_;
  int maximum_ = 0;
};

}  // namespace

displacement_map read_pgm(std::string_view bytes, std::string const& name) { return pgm_reader(bytes, name).read(); }

}  // namespace relievo::tb
