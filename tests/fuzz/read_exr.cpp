// read_exr on any bytes, with a sample range and without.
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/map_target.hpp"

int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace relievo;
  test::fuzz(data, size, [](std::string_view bytes) { test::use(tb::read_exr(bytes, "fuzz", {})); });
  return test::fuzz(data, size, [](std::string_view bytes) { test::use(tb::read_exr(bytes, "fuzz", tb::sample_range{-1000.0, 1000.0})); });
}
