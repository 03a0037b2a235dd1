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
// Clocks and links of the last run.
cosim_result const& last_cosim_result();

}  // namespace relievo::tb
