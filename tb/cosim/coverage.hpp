// coverage: what of a circuit a Verilated model has gone through, kept when it is done with.
//   keep_coverage kept(context);   after the model, which must outlive it
//   kept.begin();                  after the first clock of reset, or when a pipeline holds nothing any more of what it began with
//   In a build for coverage (RELIEVO_RTL_COVERAGE, scripts/coverage.sh) two files per model in the folder RELIEVO_COVERAGE of the
//   environment; in any other build nothing. N.dat is all that was counted, N.begin.dat what was counted until the first begin():
//   registers, and what Verilator compares bits with, begin with random words, so bits that change there have not toggled. Where
//   begin() is forgotten none has.
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
  explicit keep_coverage(VerilatedContext& context) : context_(context) {
    static std::atomic<int> count{0};
    name_ = std::to_string(getpid()) + "_" + std::to_string(count++);
  }
  ~keep_coverage() {
    begin();
    write(".dat");
  }
  void begin() {
    if (begun_) return;
    begun_ = true;
    write(".begin.dat");
  }

 private:
  void write(char const* kind) const {
    if (char const* folder = std::getenv("RELIEVO_COVERAGE"))
      context_.coveragep()->write((std::string(folder) + "/" + name_ + kind).c_str());
  }
  VerilatedContext& context_;
  std::string name_;
  bool begun_ = false;

 public:
#else
  explicit keep_coverage(VerilatedContext&) {}
  void begin() {}

#endif
  keep_coverage(keep_coverage const&) = delete;
  keep_coverage& operator=(keep_coverage const&) = delete;
};

}  // namespace relievo::tb
