// input_error: what the user gave cannot be used. One clear line: which file or option, which field, what would be right.
// The command line prints it to stderr and leaves with exit code 2.
#pragma once
#include <stdexcept>
#include <string>

namespace relievo::tb {

struct input_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace relievo::tb
