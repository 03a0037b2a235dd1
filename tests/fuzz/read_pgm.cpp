// read_pgm on any bytes.
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/map_target.hpp"

int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace relievo;
  return test::fuzz(data, size, [](std::string_view bytes) { test::use(tb::read_pgm(bytes, "fuzz")); });
}
