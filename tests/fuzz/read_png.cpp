// read_png on any bytes; pictures above 256 samples along an axis stop at the decoder, so that a few bytes can't ask for gigabytes.
#include "tb/host/png_codec.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/map_target.hpp"

int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace relievo;
  return test::fuzz(data, size, [](std::string_view bytes) {
    tb::decode_png(bytes, "fuzz", 256);
    test::use(tb::read_png(bytes, "fuzz"));
  });
}
