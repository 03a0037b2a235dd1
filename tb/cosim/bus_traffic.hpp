// bus_traffic: what goes over the buses around a top and how busy they are, and where a broken rule of one of them is told.
#pragma once
#include <cstdint>
#include <functional>
#include <random>
#include <string>

#include "tb/cosim/pacer.hpp"

namespace relievo::tb {

// A word of AXI4-Stream with its tlast.
template <class Word>
struct bus_word {
  Word word;
  bool last;
};

struct bus_traffic {
  int idle = 0, stall = 0;                // percent of clocks in which sources rest, sinks and memories refuse
  int latency_low = 1, latency_high = 1;  // clocks from a request to its answer, 1 at least
  bool bursty = false;                    // the memories answer in the second half of every 64 clocks alone
  std::uint64_t seed = 1;
  int reset_seed = 1;  // what registers hold before reset
};

// What a bench does with a broken rule: a test fails, the command line throws.
using failure_hook = std::function<void(std::string const&)>;

// When the memory of a port answers a request of now, which stays behind those of before.
class answer_times {
 public:
  answer_times(bus_traffic const& t, std::uint64_t salt) : traffic_(t), random_(static_cast<std::uint_fast32_t>(t.seed + salt)) {}
  std::uint64_t due(std::uint64_t clock, std::uint64_t last_due) {
    std::uint64_t at = clock + static_cast<std::uint64_t>(traffic_.latency_low);
    if (traffic_.latency_high > traffic_.latency_low)
      at += random_() % static_cast<std::uint64_t>(traffic_.latency_high - traffic_.latency_low + 1);
    return at > last_due ? at : last_due + 1;
  }
  bool open(std::uint64_t clock) const { return !traffic_.bursty || clock % 64 >= 32; }

 private:
  bus_traffic traffic_;
  std::minstd_rand random_;
};

}  // namespace relievo::tb
