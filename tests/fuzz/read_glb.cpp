// read_glb on any bytes.
#include "tb/host/read_mesh.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/mesh_target.hpp"

int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace relievo;
  return test::fuzz(data, size, [](std::string_view bytes) { test::use(tb::read_glb(bytes, "fuzz")); });
}
