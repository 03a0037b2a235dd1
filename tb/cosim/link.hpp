// link: a valid/ready stream between two modules of the bench, and what is checked of every one of them in every run.
//   A word moves when valid && ready at a rising edge; while valid && !ready, valid and the word hold; in reset valid is 0.
//   A response link has no ready: what comes is taken.
// link_checker looks at one link at every edge: a broken rule ends the run with the link's name and clock. It also counts what moved, what
// waited (valid, not ready) and what was idle, which is what the watchdog and the report of stalls print.
#pragma once
#include <algorithm>
#include <cstdint>
#include <ostream>
#include <string>
#include <systemc>

#include "hls/core/packed.hpp"

namespace relievo::hls {
// What sc_signal asks of its type; nobody prints a word this way.
template <int N>
std::ostream& operator<<(std::ostream& out, bits<N> const& word) {
  return out << word.limb[0];
}
template <int N>
void sc_trace(sc_core::sc_trace_file*, bits<N> const&, std::string const&) {}
}  // namespace relievo::hls

namespace relievo::tb {

// What all modules of a bench share. running is the reset, active low. The first failure is kept for the host to throw: an exception that
// leaves a SystemC process would lose its type.
struct bench_wires {
  sc_core::sc_clock clock{"clock", 1, sc_core::SC_NS};
  sc_core::sc_signal<bool> running;
  std::string failure;
  std::uint64_t clocks = 0;

  void fail(std::string const& what) {
    if (failure.empty()) failure = what + ", clock " + std::to_string(clocks);
  }
};

template <class Word>
struct link {
  explicit link(std::string const& n) : name(n) {}
  std::string name;
  sc_core::sc_signal<bool> valid, ready;
  sc_core::sc_signal<Word> word;
};

struct link_counts {
  std::string name;
  std::uint64_t moved = 0, waited = 0, idle = 0;
  std::uint64_t quiet = 0;  // clocks since a word moved
  // Of a link of answers: words asked for and not answered, added up over the clocks, the most, and now.
  std::uint64_t in_flight_clocks = 0, most_in_flight = 0, in_flight = 0;
  bool waiting = false;
};

class link_observer {
 public:
  virtual ~link_observer() = default;
  virtual link_counts const& counts() const = 0;
  virtual bool is_answers() const = 0;
  virtual void forget() = 0;
};

template <class Word>
class link_checker : public sc_core::sc_module, public link_observer {
 public:
  SC_HAS_PROCESS(link_checker);
  link_checker(sc_core::sc_module_name name, link<Word>& l, bench_wires& wires, bool has_ready, link_observer const* requests = nullptr)
      : sc_module(name), link_(l), wires_(wires), has_ready_(has_ready), requests_(requests) {
    counts_.name = l.name;
    SC_METHOD(check);
    sensitive << wires.clock.posedge_event();
    dont_initialize();
  }
  link_counts const& counts() const override { return counts_; }
  bool is_answers() const override { return requests_ != nullptr; }
  void forget() override {
    const std::string name = counts_.name;
    counts_ = link_counts();
    counts_.name = name;
    held_ = false;
  }

 private:
  void check() {
    const bool valid = link_.valid.read();
    const bool ready = !has_ready_ || link_.ready.read();
    if (!wires_.running.read()) {
      held_ = false;
      if (valid && in_reset_++ > 0) wires_.fail(link_.name + ": valid in reset");
      return;
    }
    in_reset_ = 0;
    if (held_ && !valid) wires_.fail(link_.name + ": valid fell before the word was taken");
    if (held_ && link_.word.read() != held_word_) wires_.fail(link_.name + ": the word changed before it was taken");
    const bool moves = valid && ready;
    held_ = valid && !ready;
    if (held_) held_word_ = link_.word.read();
    counts_.moved += moves ? 1 : 0;
    counts_.waited += held_ ? 1 : 0;
    counts_.idle += valid ? 0 : 1;
    counts_.quiet = moves ? 0 : counts_.quiet + 1;
    counts_.waiting = held_;
    if (requests_ == nullptr) return;
    counts_.in_flight = requests_->counts().moved - counts_.moved;
    counts_.in_flight_clocks += counts_.in_flight;
    counts_.most_in_flight = std::max(counts_.most_in_flight, counts_.in_flight);
  }

  link<Word>& link_;
  bench_wires& wires_;
  bool has_ready_;
  link_observer const* requests_;
  bool held_ = false;
  int in_reset_ = 0;  // clocks of it with valid; in the first one it may still stand
  Word held_word_{};
  link_counts counts_;
};

}  // namespace relievo::tb
