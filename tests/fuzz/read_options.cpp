// The texts of the command line: options of a scene, names of meshes and maps of our own making. The first byte chooses which.
#include "tb/host/base_meshes.hpp"
#include "tb/host/scene_options.hpp"
#include "tests/fuzz/fuzz.hpp"

int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace relievo;
  if (size == 0) return 0;
  return test::fuzz(data + 1, size - 1, [&](std::string_view bytes) {
    const std::string text(bytes);
    // A line break in an option would stand in the message; the shell's user sees what he typed.
    if (text.find('\n') != std::string::npos) return;
    switch (data[0] % 8) {
      case 0:
        tb::parse_tests(text, "--tests");
        break;
      case 1:
        tb::parse_address(text, "--address");
        break;
      case 2:
        tb::parse_vector3(text, "--eye");
        break;
      case 3:
        tb::parse_viewport(text, "--viewport");
        break;
      case 4:
        tb::parse_sample_range(text, "--sample-range");
        break;
      // Numbers of at most two digits: larger meshes and maps only take time.
      case 5:
        if (text.size() < 14) tb::make_base_mesh(text, glm::dvec2(1.0));
        break;
      case 6:
        if (text.size() < 16) tb::generate_map(text);
        break;
      default:
        tb::parse_vector2(text, "--texel-size");
        break;
    }
  });
}
