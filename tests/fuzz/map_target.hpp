// map_target: what has to hold for a map that a reader lets through, whatever the bytes were.
#pragma once
#include <cstdlib>

#include "tb/host/map.hpp"

namespace relievo::test {

inline void use(tb::displacement_map map) {
  if (map.width < 1 || map.height < 1 || map.width > tb::max_map_size || map.height > tb::max_map_size) std::abort();
  if (map.texels.size() != static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height)) std::abort();
  tb::measure(map);
  map.wrap_u = map.wrap_v = true;
  tb::measure(map);
}

}  // namespace relievo::test
