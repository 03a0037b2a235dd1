// rtl_model: the circuit in its SystemC bench as a model among the others.
#pragma once
#include <memory>

#include "tb/cosim/engine_bench.hpp"
#include "tb/model/model.hpp"

namespace relievo::tb {

// Makes "rtl" one of the models of this program.
void add_rtl_model();
// How the bench runs; to be called before the first run of the process, later calls change nothing.
void set_cosim_settings(cosim_settings const& settings);
// For tests: a reset ends the following runs so many clocks after their start (0: none does); whether each run begins with a reset.
void set_cosim_abort(std::uint64_t clocks);
void set_cosim_reset_between(bool reset);
// Clocks and links of the last run.
cosim_result const& last_cosim_result();

}  // namespace relievo::tb
