// input_error: what the user gave cannot be used. One clear line: which file or option, which field, what would be right.
// The command line prints it to stderr and leaves with exit code 2.
#pragma once
#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace relievo::tb {

struct input_error : std::runtime_error {
  // Names out of a file may hold anything; the line stays one line, and a terminal is not told what to do.
  explicit input_error(std::string what) : std::runtime_error(printable(std::move(what))) {}

 private:
  static std::string printable(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return text;
  }
};

}  // namespace relievo::tb
