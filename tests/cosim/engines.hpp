// engines: the circuit of the edge engine with several build parameters, and how a test runs one.
//   default  one lane, 12 words of the table and 4 samples of a profile a clock, 4,096 entries in the queue
//   small    one lane, 3 words, 1 sample, 49 entries: the smallest queue that the proof allows
//   wide     three lanes of 12 words and 4 samples each, 4,096 entries
//   in a build with RELIEVO_CAMPAIGN (scripts/regress.sh) also narrow (1 word, 1 sample), three (3, 1), four (4, 16) and foreign: the
//            default one as somebody else's RTL (tests/foreign/relievo_engine.v)
#pragma once
#include "tb/cosim/engine_bench.hpp"
#include "tb/model/model.hpp"

namespace relievo::test {

struct cosim_run {
  tb::run_result run;
  tb::cosim_result circuit;
};

// The scene through the circuit. One engine and one traffic a process.
cosim_run run_circuit(tb::scene const& sc, tb::cosim_settings const& settings);

void add_small_engine();
void add_wide_engine();
void add_campaign_engines();

}  // namespace relievo::test
