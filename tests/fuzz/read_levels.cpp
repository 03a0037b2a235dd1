// read_levels on any bytes: what it lets through is a whole pyramid.
#include "tb/host/filter_levels.hpp"
#include "tb/host/level_axis.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/map_target.hpp"

int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace relievo;
  return test::fuzz(data, size, [](std::string_view bytes) {
    tb::has_levels(bytes);
    const tb::filter_levels read = tb::read_levels(bytes, "fuzz");
    if (read.levels.size() != static_cast<std::size_t>(tb::levels_of(read.levels[0].width, read.levels[0].height))) std::abort();
    for (tb::displacement_map const& level : read.levels) test::use(level);
  });
}
