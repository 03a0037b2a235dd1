// main of the test programs: GoogleTest's, and one seed for everything random: --seed N (also RELIEVO_SEED), --vectors N random vectors a
// unit (also RELIEVO_VECTORS). Both are printed, so that a failing run can be repeated.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/support/settings.hpp"

namespace relievo::test {
settings& current_settings() {
  static settings s;
  return s;
}
}  // namespace relievo::test

// SystemC's library brings a main of its own that calls this; with ours it is only there to satisfy the linker.
extern "C" int sc_main(int, char**);
int sc_main(int, char**) { return 0; }

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  relievo::test::settings& s = relievo::test::current_settings();
  if (char const* seed = std::getenv("RELIEVO_SEED")) s.seed = std::strtoull(seed, nullptr, 10);
  if (char const* vectors = std::getenv("RELIEVO_VECTORS")) s.vectors = std::strtoull(vectors, nullptr, 10);
  for (int i = 1; i + 1 < argc; ++i) {
    if (argv[i] == std::string("--seed")) s.seed = std::strtoull(argv[i + 1], nullptr, 10);
    if (argv[i] == std::string("--vectors")) s.vectors = std::strtoull(argv[i + 1], nullptr, 10);
  }
  std::printf("seed %llu, %llu random vectors a unit\n", static_cast<unsigned long long>(s.seed),
              static_cast<unsigned long long>(s.vectors));
  return RUN_ALL_TESTS();
}
