// fuzz: what every fuzz target shares. A reader may refuse its input with an input_error of one line; anything else that leaves it, and
// anything that the sanitizers see, is a fault.
//
// A target is one file, tests/fuzz/<reader>.cpp, with a corpus of a few small files in tests/fuzz/corpus/<reader>/. Built with the preset
// `fuzz` it is a libFuzzer program; otherwise replay.cpp runs it over its corpus, in every build of the regression.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "tb/host/input_error.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size);  // NOLINT: libFuzzer gives the name

namespace relievo::test {

template <class Call>
int fuzz(std::uint8_t const* data, std::size_t size, Call const& call) {
  try {
    call(std::string_view(reinterpret_cast<char const*>(data), size));
  } catch (tb::input_error const& e) {
    if (std::string_view(e.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}

}  // namespace relievo::test
