#include "tb/cosim/waveform.hpp"

#include <verilated_fst_c.h>

#include <cstdio>

#include "tb/cosim/gtkwave_save.hpp"
#include "tb/host/files.hpp"

namespace relievo::tb {

fst_file::fst_file(std::string const& name, std::function<void(VerilatedFstC*)> const& attach)
    : name_(name), file_(std::make_unique<VerilatedFstC>()) {
  attach(file_.get());
  file_->open((name_ + ".part").c_str());
}

fst_file::~fst_file() = default;

void fst_file::dump(std::uint64_t picoseconds) { file_->dump(picoseconds); }

void fst_file::close() {
  file_->close();
  const std::string part = name_ + ".part";
  if (std::rename(part.c_str(), name_.c_str()) != 0) {
    std::remove(part.c_str());
    throw input_error(name_ + ": cannot be written");
  }
  write_bytes(gtkwave_name(name_), gtkwave_save(name_));
}

}  // namespace relievo::tb
