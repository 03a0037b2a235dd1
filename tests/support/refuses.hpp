// refuses: a call has to throw input_error with one line that contains every given text (a file's name, a field, what would be right).
#pragma once
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "tb/host/input_error.hpp"

namespace relievo::test {

template <class Call>
testing::AssertionResult refuses(Call const& call, std::initializer_list<std::string> texts) {
  try {
    call();
  } catch (tb::input_error const& e) {
    const std::string line = e.what();
    if (line.find('\n') != std::string::npos) return testing::AssertionFailure() << "more than one line: " << line;
    for (std::string const& text : texts)
      if (line.find(text) == std::string::npos) return testing::AssertionFailure() << "'" << text << "' is missing in: " << line;
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "not refused";
}

}  // namespace relievo::test
