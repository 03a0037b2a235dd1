// rejected: dynamic stack
// A profile with as many samples as the edge asks for.
#include <cstdint>

std::int32_t profile_dynamic(std::uint32_t samples, std::uint32_t k) {
  auto* profile = static_cast<std::int32_t*>(__builtin_alloca(4 * samples));
  profile[0] = 1;
  profile[k] = 2;
  return profile[0];
}
