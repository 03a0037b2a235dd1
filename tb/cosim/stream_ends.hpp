// stream_ends: the source that drives a link from a list of words, the sink that gathers what comes out, and the memory behind a read port.
// Each has a pacer. All act at the rising edge on what stood before it.
#pragma once
#include <deque>
#include <functional>
#include <vector>

#include "tb/cosim/bus_traffic.hpp"
#include "tb/cosim/link.hpp"
#include "tb/cosim/pacer.hpp"

namespace relievo::tb {

template <class Word>
class source : public sc_core::sc_module {
 public:
  SC_HAS_PROCESS(source);
  source(sc_core::sc_module_name name, link<Word>& l, bench_wires& wires, pacer const& pace)
      : sc_module(name), link_(l), wires_(wires), pace_(pace) {
    SC_METHOD(step);
    sensitive << wires.clock.posedge_event();
    dont_initialize();
  }
  void load(std::vector<Word> const* words) {
    words_ = words;
    at_ = 0;
  }
  std::size_t sent() const { return at_; }
  void set_pace(pacer const& pace) { pace_ = pace; }

 private:
  void step() {
    if (!wires_.running.read()) {
      at_ = 0;
      link_.valid.write(false);
      return;
    }
    const bool offered = link_.valid.read();
    if (offered && link_.ready.read()) ++at_;
    // A word that was offered and not taken stays.
    const bool stays = offered && !link_.ready.read();
    const bool offer = stays || (words_ != nullptr && at_ < words_->size() && pace_.go());
    link_.valid.write(offer);
    if (offer && !stays) link_.word.write((*words_)[at_]);
  }

  link<Word>& link_;
  bench_wires& wires_;
  pacer pace_;
  std::vector<Word> const* words_ = nullptr;
  std::size_t at_ = 0;
};

template <class Word>
class sink : public sc_core::sc_module {
 public:
  SC_HAS_PROCESS(sink);
  sink(sc_core::sc_module_name name, link<Word>& l, bench_wires& wires, pacer const& pace)
      : sc_module(name), link_(l), wires_(wires), pace_(pace) {
    SC_METHOD(step);
    sensitive << wires.clock.posedge_event();
    dont_initialize();
  }
  std::function<void(Word const&)> take;
  void set_pace(pacer const& pace) { pace_ = pace; }

 private:
  void step() {
    if (wires_.running.read() && link_.valid.read() && link_.ready.read() && take) take(link_.word.read());
    link_.ready.write(pace_.go());
  }

  link<Word>& link_;
  bench_wires& wires_;
  pacer pace_;
};

template <class Request, class Answer>
class memory : public sc_core::sc_module {
 public:
  SC_HAS_PROCESS(memory);
  using request_word = hls::port_word<Request>;
  using answer_word = hls::port_word<Answer>;
  memory(sc_core::sc_module_name name, link<request_word>& requests, link<answer_word>& answers, bench_wires& wires, pacer const& pace,
         answer_times const& times)
      : sc_module(name), requests_(requests), answers_(answers), wires_(wires), pace_(pace), times_(times) {
    SC_METHOD(step);
    sensitive << wires.clock.posedge_event();
    dont_initialize();
  }
  std::function<Answer(Request const&)> look_up;
  bool empty() const { return pending_.empty(); }

 private:
  struct pending {
    std::uint64_t due;
    answer_word word;
  };
  void step() {
    ++clock_;
    if (!wires_.running.read()) {
      pending_.clear();
      answers_.valid.write(false);
      requests_.ready.write(false);
      return;
    }
    if (requests_.valid.read() && requests_.ready.read()) {
      // The request went over in the clock that ends here.
      const std::uint64_t due = times_.due(clock_ - 1, pending_.empty() ? 0 : pending_.back().due);
      pending_.push_back({due, hls::pack(look_up(hls::unpack<Request>(requests_.word.read())))});
    }
    const bool due = times_.open(clock_) && !pending_.empty() && pending_.front().due <= clock_;
    answers_.valid.write(due);
    if (due) {
      answers_.word.write(pending_.front().word);
      pending_.pop_front();
    }
    requests_.ready.write(pace_.go());
  }

  link<request_word>& requests_;
  link<answer_word>& answers_;
  bench_wires& wires_;
  pacer pace_;
  answer_times times_;
  std::deque<pending> pending_;
  std::uint64_t clock_ = 0;
};

}  // namespace relievo::tb
