// coverage: what of a circuit a Verilated model has gone through, kept when it is done with.
//   const keep_coverage kept(context);     after the model, which must outlive it
//   In a build for coverage (RELIEVO_RTL_COVERAGE, scripts/coverage.sh) a file per model in the folder that the environment names in
//   RELIEVO_COVERAGE; in any other build nothing.
#pragma once
#include <verilated.h>
#ifdef RELIEVO_RTL_COVERAGE
#include <unistd.h>
#include <verilated_cov.h>

#include <atomic>
#include <cstdlib>
#include <string>
#endif

namespace relievo::tb {

class keep_coverage {
 public:
#ifdef RELIEVO_RTL_COVERAGE
  explicit keep_coverage(VerilatedContext& context) : context_(context) {}
  ~keep_coverage() {
    static std::atomic<int> count{0};
    if (char const* folder = std::getenv("RELIEVO_COVERAGE")) {
      const std::string name = std::to_string(getpid()) + "_" + std::to_string(count++);
      context_.coveragep()->write((std::string(folder) + "/" + name + ".dat").c_str());
    }
  }

 private:
  VerilatedContext& context_;

 public:
#else
  explicit keep_coverage(VerilatedContext&) {}

#endif
  keep_coverage(keep_coverage const&) = delete;
  keep_coverage& operator=(keep_coverage const&) = delete;
};

}  // namespace relievo::tb
